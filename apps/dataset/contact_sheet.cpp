#include "dataset/contact_sheet.h"

#include <iostream>
#include <stdexcept>

#include "apps/options.h"
#include "apps/verbs.h"
#include "files/files.h"
#include "files/png.h"

namespace po = boost::program_options;

namespace cps {

const Manual contact_sheet_manual{
    .name = "cps contact-sheet",
    .summary = "draw views of a dataset through their lenses, in one picture",
    .synopsis = {"DATASET -o FILE.png [--rows N] [--columns N]"},
    .description = R"(
Draws one picture of a dataset: a row per view, its images side by side, each
through its lens and with its label.
)",
    .examples = {{"cps contact-sheet data -o sheet.png", "draws the dataset in the folder data"}},
    .see_also = {"cps generate", "cps verify"},
};

int cps_contact_sheet(const Arguments& arguments) {
  ContactSheetOptions sheet;
  po::options_description options("Options");
  auto add = options.add_options();
  add("dataset", po::value<std::string>()->value_name("DATASET")->required(),
      "the dataset's folder; its name alone will do, without --dataset");
  add("out,o", po::value<std::string>()->value_name("FILE")->required(), "the .png file to write");
  add("rows", po::value(&sheet.rows_per_set)->default_value(sheet.rows_per_set),
      "number of views from each set of one size and H-FOV");
  add("columns", po::value(&sheet.columns)->default_value(sheet.columns),
      "largest number of images per view");
  add("tile-width", po::value(&sheet.tile_width_px)->default_value(sheet.tile_width_px),
      "width of an image in the sheet, pixels");
  po::positional_options_description positional;
  positional.add("dataset", 1);
  po::variables_map values;
  if (!parse_options(arguments, contact_sheet_manual, options, positional, values)) return 0;
  po::notify(values);
  if (const std::string fault = sheet.fault(); !fault.empty()) throw po::error(fault);
  const Dataset dataset = read_dataset(values["dataset"].as<std::string>(), LensFamilies::any);
  const std::string output = values["out"].as<std::string>();
  write_file(output, encode_png(contact_sheet(dataset, sheet)));
  std::cout << output << ": " << dataset.images.size() << " images, " << dataset.groups.size() << " groups\n";
  return 0;
}

}  // namespace cps
