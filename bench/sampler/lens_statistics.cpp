#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "files/files.h"
#include "files/plot.h"
#include "numbers/angles.h"
#include "sampler/lenses/lens_draw.h"
#include "sampler/lenses/sequential_draw.h"

/// Prints the tables and draws the pictures of docs/benchmarks/lens-draws.md and docs/lenses.md. Usage:
/// lens_statistics docs/pictures
namespace {

using namespace cps;

constexpr int lens_count = 6000;
constexpr LensScheme schemes[] = {LensScheme::sequential, LensScheme::shape_prior, LensScheme::real_lenses};
constexpr CropOrder orders[] = {CropOrder::base_first, CropOrder::label_first};
constexpr double hfovs_deg[] = {50, 60, 70, 80, 90, 100, 110, 120, 130};

using Values = std::vector<double>;

Eigen::Map<const Eigen::ArrayXd> array(const Values& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

double standard_deviation(const Values& values) {
  return std::sqrt((array(values) - array(values).mean()).square().mean());
}

double correlation(const Values& x, const Values& y) {
  const double covariance = ((array(x) - array(x).mean()) * (array(y) - array(y).mean())).mean();
  return covariance / (standard_deviation(x) * standard_deviation(y));
}

/// Drawn lenses, one value per lens; coefficients in units of the base's half diagonal.
struct Sample {
  Values k1, k2, k3, corner, label_hfov_deg, base_hfov_deg, zoom;
};

/// Draws lenses at one H-FOV, or, if it is 0, at each of `hfovs_deg` in turn.
Sample draw(LensScheme scheme, CropOrder order, double one_hfov_deg) {
  const LensOptions options{
      .scheme = scheme, .sequential_share = 0, .coefficients = {}, .bounds = {}, .principal_point = {}};
  Sample sample;
  for (int i = 0; i < lens_count; ++i) {
    const double hfov_deg = one_hfov_deg > 0 ? one_hfov_deg : hfovs_deg[i % std::size(hfovs_deg)];
    const Pinhole camera = pinhole_from_hfov(480, 270, radians(hfov_deg));
    const DrawnLens lens = draw_lens(camera, order, options, substream(make_stream(1, "statistics"), i));
    const Distortion k = rescaled(lens.distortion, 0.5 * frame_on_plane(lens.base).diagonal().norm());
    sample.k1.push_back(k.k1);
    sample.k2.push_back(k.k2);
    sample.k3.push_back(k.k3);
    sample.corner.push_back(k.k1 + k.k2 + k.k3);
    sample.label_hfov_deg.push_back(degrees(hfov_rad(lens.crop.camera)));
    sample.base_hfov_deg.push_back(degrees(hfov_rad(lens.base)));
    sample.zoom.push_back(lens.crop.zoom);
  }
  return sample;
}

PlotSeries dots(const std::string& name, const Values& x, const Values& y, std::size_t count) {
  PlotSeries series{.name = name, .style = PlotStyle::dots, .points = {}};
  for (std::size_t i = 0; i < std::min(count, x.size()); ++i) series.points.emplace_back(x[i], y[i]);
  return series;
}

/// Plots of the lenses of each scheme: K1 against K2, displacement of the corner, zoom.
std::string schemes_picture() {
  std::vector<Plot> plots;
  Plot corner{.title = "Displacement of the corner",
              .x_label = "K1 + K2 + K3, of the half diagonal",
              .y_label = "density",
              .series = {},
              .x_range = Interval{-0.4, 0.4},
              .y_range = {}};
  Plot zoom{.title = "Zoom of the border-free crop",
            .x_label = "zoom",
            .y_label = "density",
            .series = {},
            .x_range = Interval{1, 2},
            .y_range = Interval{0, 8}};
  for (LensScheme scheme : schemes) {
    const Sample sample = draw(scheme, CropOrder::base_first, 70);
    plots.push_back({.title = to_string(scheme) + ", base H-FOV 70°",
                     .x_label = "K1",
                     .y_label = "K2",
                     .series = {dots("", sample.k1, sample.k2, 1500)},
                     .x_range = Interval{-1, 1},
                     .y_range = Interval{-1.5, 1.5}});
    corner.series.push_back(histogram(to_string(scheme), sample.corner, {-0.4, 0.4}, 40));
    zoom.series.push_back(histogram(to_string(scheme), sample.zoom, {1, 2}, 40));
  }
  plots.push_back(corner);
  plots.push_back(zoom);
  return to_svg(plots, 3);
}

/// Prints the spread of each coefficient by its position in the sequential order. Returns the plots.
std::string order_effects() {
  const Pinhole camera = pinhole_from_hfov(480, 270, radians(90));
  Pinhole unit = camera;
  unit.fx = unit.fy = camera.fx * 0.5 * frame_on_plane(camera).diagonal().norm();
  Values values[5][5];  // by coefficient and position
  for (int i = 0; i < 4 * lens_count; ++i) {
    const SequentialDraw drawn =
        draw_sequential(frame_on_plane(unit), {}, {}, substream(make_stream(2, "statistics"), i));
    for (int position = 0; position < 5; ++position) {
      const int which = drawn.order[position];
      values[which][position].push_back(coefficient(drawn.lens, static_cast<Coefficient>(which)));
    }
  }
  constexpr const char* names[] = {"K1", "K2", "K3", "P1", "P2"};
  std::vector<Plot> plots(2);
  plots[0] = {.title = "Sequential draws: spread by position",
              .x_label = "drawn first … last",
              .y_label = "standard deviation",
              .series = {},
              .x_range = {},
              .y_range = {}};
  plots[1] = plots[0];
  std::cout << "| standard deviation when drawn | 1st | 2nd | 3rd | 4th | 5th |\n|---|---|---|---|---|---|\n";
  for (int which = 0; which < 5; ++which) {
    PlotSeries line{.name = names[which], .style = PlotStyle::line, .points = {}};
    std::cout << "| " << names[which];
    for (int position = 0; position < 5; ++position) {
      const double sd = standard_deviation(values[which][position]);
      line.points.emplace_back(position + 1, sd);
      std::cout << fmt::format(" | {:.4f}", sd);
    }
    std::cout << " |\n";
    plots[which < 3 ? 0 : 1].series.push_back(line);
  }
  plots[0].y_range = Interval{0, 0.6};
  plots[1].y_range = Interval{0, 0.012};
  return to_svg(plots, 2);
}

/// Prints the correlations that the crop causes. Returns the plots.
std::string label_correlations() {
  std::vector<Plot> plots;
  std::cout << "\n| scheme | crop | label H-FOV–K1 | within one set | K1–K2 | K1–K3 | K2–K3 |\n"
               "|---|---|---|---|---|---|---|\n";
  for (LensScheme scheme : schemes)
    for (CropOrder order : orders) {
      const Sample all = draw(scheme, order, 0), one = draw(scheme, order, 90);
      const bool is_base_first = order == CropOrder::base_first;
      std::cout << fmt::format(
          "| {} | {} | {:.2f} | {} | {:.2f} | {:.2f} | {:.2f} |\n", to_string(scheme),
          is_base_first ? "base-first" : "label-first", correlation(all.label_hfov_deg, all.k1),
          is_base_first ? fmt::format("{:.2f}", correlation(one.label_hfov_deg, one.k1)) : "constant",
          correlation(all.k1, all.k2), correlation(all.k1, all.k3), correlation(all.k2, all.k3));
      if (scheme != LensScheme::shape_prior) continue;
      plots.push_back({.title = is_base_first ? "base-first: nine bases" : "label-first: nine labels",
                       .x_label = "label H-FOV [°]",
                       .y_label = "K1",
                       .series = {dots("", all.label_hfov_deg, all.k1, 2500)},
                       .x_range = Interval{30, 140},
                       .y_range = Interval{-1, 1}});
    }
  return to_svg(plots, 2);
}

/// Plots of the bases that the labels need.
void print_bases() {
  std::cout << "\n| label H-FOV | median base | largest of " << lens_count << " |\n|---|---|---|\n";
  for (double hfov_deg : {30.0, 60.0, 90.0, 120.0, 150.0}) {
    Values base = draw(LensScheme::shape_prior, CropOrder::label_first, hfov_deg).base_hfov_deg;
    std::sort(base.begin(), base.end());
    std::cout << fmt::format("| {}° | {:.1f}° | {:.1f}° |\n", hfov_deg, base[base.size() / 2], base.back());
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "lens_statistics FOLDER: prints tables, writes pictures into FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  write_file(folder / "lens_schemes.svg", schemes_picture());
  write_file(folder / "lens_order.svg", order_effects());
  write_file(folder / "lens_labels.svg", label_correlations());
  print_bases();
  return 0;
} catch (const std::exception& error) {
  std::cerr << "lens_statistics: " << error.what() << "\n";
  return 1;
}
