#include <iostream>

#include "apps/options.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "dataset/report/page.h"
#include "files/files.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
const Manual report_manual{
    .name = "cps report",
    .summary = "describe a dataset on one HTML page",
    .synopsis = {"DATASET [-o FILE.html] [--thumbnails N] [--lenses N]"},
    .description = R"(
Writes a page that needs no other file and no network: counts, contact sheets,
distributions of all labels beside their limits, maps of the places, light and
weather, what cps verify found, what the dataset cost, and a list of lenses that
are drawn on demand. However large the dataset is, the page stays below 10 MB.
)",
    .examples = {{"cps report data", "writes data/report.html"}},
    .see_also = {"cps verify", "cps contact-sheet"},
};

int cps_report(const Arguments& arguments) {
  ReportOptions report;
  po::options_description options("Options");
  auto add = options.add_options();
  add("dataset", po::value<std::string>()->value_name("DATASET")->required(),
      "the dataset's folder; its name alone will do, without --dataset");
  add("out,o", po::value<std::string>()->value_name("FILE.html"),
      "the .html file to write [report.html in the dataset's folder]");
  add("thumbnails", po::value(&report.thumbnails)->default_value(report.thumbnails),
      "largest number of images in the contact sheets, all together, 0 to 400");
  add("rows", po::value(&report.rows_per_set)->default_value(report.rows_per_set),
      "number of views from each set of one size and H-FOV, as far as the thumbnails reach");
  add("columns", po::value(&report.columns)->default_value(report.columns),
      "largest number of images per view, 1 to 20");
  add("thumbnail-width", po::value(&report.thumbnail_width_px)->default_value(report.thumbnail_width_px),
      "longer side of those images, pixels, 32 to 640");
  add("lenses", po::value(&report.lenses)->default_value(report.lenses),
      "number of lenses that can be drawn, 1 to 2000");
  add_threads_option(options);
  po::positional_options_description positional;
  positional.add("dataset", 1);
  po::variables_map values;
  if (!parse_options(arguments, report_manual, options, positional, values)) return 0;
  po::notify(values);
  refuse_flags_with(report.fault());
  const ThreadLimit threads(values);
  const fs::path root = values["dataset"].as<std::string>();
  const fs::path output =
      values.count("out") > 0 ? fs::path(values["out"].as<std::string>()) : root / "report.html";
  if (fs::is_directory(output))
    throw std::runtime_error(output.string() + ": is a folder; name a file to write, as report.html");
  const std::string page = report_page(root, report);
  write_file(output, page);
  std::cout << output.string() << ": " << (page.size() + 999) / 1000 << " kB\n";
  return 0;
}

}  // namespace cps
