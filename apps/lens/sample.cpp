#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/lens/verbs.h"
#include "apps/options.h"
#include "files/files.h"
#include "files/plot.h"
#include "numbers/angles.h"
#include "sampler/lenses/lens_draw.h"
#include "sampler/recipe/key_options.h"
#include "sampler/recipe/lens_keys.h"

namespace po = boost::program_options;

namespace cps {
namespace {

/// One row of the table: numbers by column name.
nlohmann::ordered_json row_of(int number, const DrawnLens& lens) {
  const Pinhole& camera = lens.crop.camera;
  return {{"number", number},
          {"k1", lens.distortion.k1},
          {"k2", lens.distortion.k2},
          {"k3", lens.distortion.k3},
          {"p1", lens.distortion.p1},
          {"p2", lens.distortion.p2},
          {"width", camera.width},
          {"height", camera.height},
          {"f", camera.fx},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"fov", degrees(hfov_rad(camera))},
          {"fov_base_deg", degrees(hfov_rad(lens.base))},
          {"zoom", lens.crop.zoom},
          {"min_eigenvalue", lens.crop.certificate.min_eigenvalue}};
}

void print_csv(const nlohmann::ordered_json& rows) {
  std::string heading;
  for (const auto& [key, value] : rows.front().items()) heading += heading.empty() ? key : "," + key;
  fmt::print("{}\n", heading);
  for (const auto& row : rows) {
    std::string line;
    for (const auto& value : row) line += line.empty() ? value.dump() : "," + value.dump();
    fmt::print("{}\n", line);
  }
}

/// Scatter plots of the drawn lenses: pairs of coefficients, the principal point, and what the crop leaves.
std::vector<Plot> sample_plots(const nlohmann::ordered_json& rows) {
  const auto scatter = [&](const char* x, const char* y) {
    PlotSeries dots{.style = PlotStyle::dots};
    for (const auto& row : rows) dots.points.emplace_back(row[x].get<double>(), row[y].get<double>());
    return Plot{.title = fmt::format("{} against {}", y, x), .x_label = x, .y_label = y, .series = {dots}};
  };
  return {scatter("k1", "k2"), scatter("k2", "k3"),  scatter("p1", "p2"),
          scatter("cx", "cy"), scatter("k1", "fov"), scatter("zoom", "min_eigenvalue")};
}

}  // namespace

const Manual lens_sample_manual{
    .name = "cps lens sample",
    .summary = "draw lenses as cps generate does",
    .synopsis =
        {"N --size WxH --hfov DEG [--label-first] [--seed S] [--lens_draw SCHEME] [--json] [-o PLOT.svg]"},
    .description = R"(
Prints N drawn Brown-Conrady lenses with the principal point and the H-FOV that
are left after the border-free crop.
)",
    .examples = {{"cps lens sample 100 --size 1920x1080 --hfov 90", "prints a hundred lenses as CSV"}},
    .see_also = {"cps lens", "cps generate"},
};

int cps_lens_sample(const Arguments& arguments) {
  int count = 0;
  std::uint64_t seed = 0;
  double hfov_deg = 0;
  std::string size_text, plot_file;
  po::options_description options("Options");
  auto add = options.add_options();
  add("count", po::value(&count)->required(),
      "number of lenses, 1 to 1000000; the number alone will do, without --count");
  add("size", po::value(&size_text)->value_name("WxH")->required(),
      "size of the images, WIDTHxHEIGHT in pixels, 32 to 8192 a side");
  add("hfov", po::value(&hfov_deg)->required(),
      "horizontal field of view of the base, before the crop, degrees, 5 to 165");
  add("label-first",
      "make --hfov the field of view of the images, after the crop; each lens gets the base that leads there");
  add("seed", po::value(&seed)->default_value(seed), "seed of the lenses, a whole number from 0");
  add("json", "print JSON instead of comma-separated values");
  add("out,o", po::value(&plot_file)->value_name("FILE"),
      "also write scatter plots of the lenses, an .svg file");
  LensOptions lenses;
  const auto for_each_key = [&](auto visit) { for_each_lens_key(lenses, visit); };
  options.add(key_options("How lenses are drawn", for_each_key));
  po::positional_options_description positional;
  positional.add("count", 1);
  po::variables_map values;
  if (!parse_options(arguments, lens_sample_manual, options, positional, values)) return 0;
  po::notify(values);
  read_key_flags(values, for_each_key);
  const auto size = flag_value<ImageSize>("size", size_text);
  if (count < 1 || count > 1'000'000) throw po::error("--count: must lie between 1 and 1000000");
  if (!(size.width >= 32 && size.height >= 32 && size.width <= 8192 && size.height <= 8192))
    throw po::error("--size: must lie between 32x32 and 8192x8192 pixels");
  if (!(hfov_deg >= 5 && hfov_deg <= 165)) throw po::error("--hfov: must lie between 5 and 165 degrees");
  refuse_flags_with(lenses.fault());

  const Pinhole camera = pinhole_from_hfov(size.width, size.height, radians(hfov_deg));
  const CropOrder order = values.count("label-first") ? CropOrder::label_first : CropOrder::base_first;
  auto rows = nlohmann::ordered_json::array();
  for (int number = 1; number <= count; ++number)
    rows.push_back(
        row_of(number, draw_lens(camera, order, lenses, substream(make_stream(seed, "lens"), number))));
  if (!plot_file.empty()) write_file(plot_file, to_svg(sample_plots(rows), 3));
  if (values.count("json"))
    fmt::print("{}\n", rows.dump(1));
  else
    print_csv(rows);
  return 0;
}

}  // namespace cps
