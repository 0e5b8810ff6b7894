#include "distortion/crop/limits.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "apps/lens/verbs.h"
#include "apps/options.h"
#include "files/files.h"
#include "files/plot.h"
#include "numbers/angles.h"
#include "sampler/recipe/key_options.h"
#include "sampler/recipe/lens_keys.h"

namespace po = boost::program_options;

namespace cps {
namespace {

constexpr std::array<std::pair<Coefficient, const char*>, 5> coefficients{{{Coefficient::k1, "k1"},
                                                                           {Coefficient::k2, "k2"},
                                                                           {Coefficient::k3, "k3"},
                                                                           {Coefficient::p1, "p1"},
                                                                           {Coefficient::p2, "p2"}}};

using Limits = std::array<Interval, coefficients.size()>;

/// The interval of each coefficient in which the lens keeps the bounds while the other coefficients are 0.
Limits lens_limits(const ImageSize& size, double hfov_deg, const LensBounds& bounds) {
  const Pinhole camera = pinhole_from_hfov(size.width, size.height, radians(hfov_deg));
  Limits limits;
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    limits[i] = coefficient_limits({}, coefficients[i].first, frame_on_plane(camera), bounds);
  return limits;
}

void print_csv(const std::vector<ImageSize>& sizes, const std::vector<double>& hfovs_deg,
               const LensBounds& bounds) {
  fmt::print("width,height,hfov_deg");
  for (const auto& [which, name] : coefficients) fmt::print(",{0}_low,{0}_high", name);
  fmt::print("\n");
  for (const ImageSize& size : sizes)
    for (double hfov_deg : hfovs_deg) {
      fmt::print("{},{},{}", size.width, size.height, hfov_deg);
      for (const Interval& limits : lens_limits(size, hfov_deg, bounds))
        fmt::print(",{},{}", limits.low, limits.high);
      fmt::print("\n");
    }
}

void print_table(const std::vector<ImageSize>& sizes, const std::vector<double>& hfovs_deg,
                 const LensBounds& bounds) {
  fmt::print("{:>9} {:>6}", "size", "H-FOV");
  for (const auto& [which, name] : coefficients) fmt::print("  {:^21}", name);
  fmt::print("\n");
  for (const ImageSize& size : sizes)
    for (double hfov_deg : hfovs_deg) {
      fmt::print("{:>9} {:>6g}", value_text(size), hfov_deg);
      for (const Interval& limits : lens_limits(size, hfov_deg, bounds))
        fmt::print("  {:>10.3g} {:>10.3g}", limits.low, limits.high);
      fmt::print("\n");
    }
}

/// Limits span decades between 30° and 150°, so the plots show the logarithms of their absolute values.
std::vector<Plot> limit_plots(const std::vector<ImageSize>& sizes, const LensBounds& bounds) {
  constexpr double first_deg = 30, last_deg = 150, step_deg = 2;
  std::vector<Plot> plots;
  for (const auto& [which, name] : coefficients)
    plots.push_back({.title = fmt::format("Limits of {}", name),
                     .x_label = "H-FOV, degrees",
                     .y_label = fmt::format("log10 |{}|", name)});
  for (const ImageSize& size : sizes) {
    std::array<PlotSeries, coefficients.size()> low, high;
    for (double hfov_deg = first_deg; hfov_deg <= last_deg; hfov_deg += step_deg) {
      const Limits limits = lens_limits(size, hfov_deg, bounds);
      for (std::size_t i = 0; i < coefficients.size(); ++i) {
        low[i].points.emplace_back(hfov_deg, std::log10(-limits[i].low));
        high[i].points.emplace_back(hfov_deg, std::log10(limits[i].high));
      }
    }
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      low[i].name = value_text(size) + ", lowest";
      high[i].name = value_text(size) + ", highest";
      plots[i].series.insert(plots[i].series.end(), {low[i], high[i]});
    }
  }
  return plots;
}

void check(const std::vector<ImageSize>& sizes, const std::vector<double>& hfovs_deg,
           const LensBounds& bounds) {
  if (sizes.empty()) throw po::error("--size: name at least one, as 1392x512");
  for (const ImageSize& size : sizes)
    if (!(size.width >= 1 && size.height >= 1 && size.width <= 100'000 && size.height <= 100'000))
      throw po::error("--size: must lie between 1x1 and 100000x100000 pixels");
  if (hfovs_deg.empty()) throw po::error("--hfov: name at least one");
  for (double hfov_deg : hfovs_deg)
    if (!(hfov_deg >= 1 && hfov_deg <= 175)) throw po::error("--hfov: must lie between 1 and 175 degrees");
  refuse_flags_with(bounds.fault());
}

}  // namespace

const Manual lens_limits_manual{
    .name = "cps lens limits",
    .summary = "compute how far each coefficient of a lens may go",
    .synopsis = {"[--size WxH,...] [--hfov DEG,...] [--csv] [-o PLOT.svg]"},
    .description = R"(
Prints, for each image size and H-FOV, the interval of each Brown-Conrady
coefficient in which a lens keeps the bounds while the others are 0.
)",
    .examples = {{"cps lens limits --size 1392x512 --hfov 60,90", "prints the limits for two fields of view"},
                 {"cps lens limits -o limits.svg", "also plots them from 30 to 150 degrees"}},
    .see_also = {"cps lens"},
};

int cps_lens_limits(const Arguments& arguments) {
  std::string size_list = "1392x512,1920x1080", hfov_list = "30,60,90,120,150", plot_file;
  po::options_description options("Options");
  auto add = options.add_options();
  add("size", po::value(&size_list)->value_name("SIZES")->default_value(size_list),
      "image sizes, WIDTHxHEIGHT in pixels, separated by commas");
  add("hfov", po::value(&hfov_list)->value_name("ANGLES")->default_value(hfov_list),
      "horizontal fields of view, degrees, separated by commas; 1 to 175");
  add("csv", "print comma-separated values with every digit instead of a table");
  add("out,o", po::value(&plot_file)->value_name("FILE"),
      "also write a plot of the limits from 30 to 150 degrees, an .svg file");
  LensBounds bounds;
  const auto for_each_key = [&](auto visit) { for_each_bound_key(bounds, visit); };
  options.add(key_options("Bounds of a lens", for_each_key));
  po::variables_map values;
  if (!parse_options(arguments, lens_limits_manual, options, {}, values)) return 0;
  po::notify(values);
  read_key_flags(values, for_each_key);
  const auto sizes = flag_value<std::vector<ImageSize>>("size", size_list);
  const auto hfovs_deg = flag_value<std::vector<double>>("hfov", hfov_list);
  check(sizes, hfovs_deg, bounds);
  if (!plot_file.empty()) write_file(plot_file, to_svg(limit_plots(sizes, bounds), 3));
  if (values.count("csv"))
    print_csv(sizes, hfovs_deg, bounds);
  else
    print_table(sizes, hfovs_deg, bounds);
  return 0;
}

}  // namespace cps
