#include "dataset/contact_sheet.h"

#include <iostream>
#include <stdexcept>

#include "apps/options.h"
#include "apps/verbs.h"
#include "files/files.h"
#include "files/png.h"

namespace po = boost::program_options;

namespace cps {

int cps_contact_sheet(const Arguments& arguments) {
  ContactSheetOptions sheet;
  po::options_description options("Options");
  options.add_options()("dataset", po::value<std::string>()->required(), "the dataset's folder")(
      "output,o", po::value<std::string>()->required(), "the picture, a .png")(
      "rows", po::value(&sheet.rows_per_set)->default_value(sheet.rows_per_set), "views of each set")(
      "columns", po::value(&sheet.columns)->default_value(sheet.columns), "most images of each view")(
      "tile-width", po::value(&sheet.tile_width_px)->default_value(sheet.tile_width_px), "pixels");
  po::positional_options_description positional;
  positional.add("dataset", 1);
  po::variables_map values;
  if (!parse_options(arguments,
                     "cps contact-sheet DATASET -o FILE\nOne picture of a dataset: views side by side "
                     "through their lenses, "
                     "with their labels.\n",
                     options, positional, values))
    return 0;
  po::notify(values);
  if (const std::string fault = sheet.fault(); !fault.empty()) throw po::error(fault);
  const Dataset dataset = read_dataset(values["dataset"].as<std::string>());
  const std::string output = values["output"].as<std::string>();
  write_file(output, encode_png(contact_sheet(dataset, sheet)));
  std::cout << output << ": " << dataset.images.size() << " images, " << dataset.groups.size() << " groups\n";
  return 0;
}

}  // namespace cps
