#include <fmt/format.h>

#include <utility>

#include "files/plot.h"
#include "numbers/angles.h"
#include "trainer/evaluation/page/sections.h"
#include "trainer/evaluation/page/shown_images.h"

namespace cps {
namespace {

/// A number that bins and images have.
struct ErrorKind {
  const char *title, *unit;
  double LensErrors::*mean;
  Interval EvaluationBin::*interval;
  std::optional<double> (*of_image)(const ImageErrors&);
};

constexpr ErrorKind error_kinds[] = {
    {"H-FOV error", "degrees", &LensErrors::hfov_mean_deg, &EvaluationBin::hfov_interval_deg,
     [](const ImageErrors& errors) { return std::optional(errors.hfov_deg); }},
    {"reprojection error", "pixels", &LensErrors::reprojection_mean_px,
     &EvaluationBin::reprojection_interval_px,
     [](const ImageErrors& errors) { return errors.reprojection_px; }}};

/// Mean errors of the bins of one kind, at their middles.
Plot bin_plot(const Evaluation& evaluation, const ErrorKind& error, const std::string& kind,
              const char* x_label) {
  PlotSeries bars{.style = PlotStyle::bars, .colour = 0, .opacity = 1},
      network{.name = "network", .colour = 0}, mean{.name = "train mean", .colour = 1};
  for (const EvaluationBin& bin : evaluation.bins) {
    if (bin.kind != kind || !bin.range) continue;
    const double x = (bin.range->low + bin.range->high) / 2;
    const Interval& interval = bin.*error.interval;
    bars.points.emplace_back(x, interval.low);
    bars.points.emplace_back(x, interval.high);
    network.points.emplace_back(x, bin.network.*error.mean);
    mean.points.emplace_back(x, bin.training_mean.*error.mean);
  }
  Plot plot{.title = fmt::format("{}, mean", error.title), .x_label = x_label, .y_label = error.unit};
  for (const PlotSeries* line : {&network, &mean})
    plot.series.push_back(
        {.style = PlotStyle::dots, .points = line->points, .colour = line->colour, .opacity = 1});
  plot.series.insert(plot.series.end(), {std::move(bars), std::move(network), std::move(mean)});
  return plot;
}

/// The error of each image.
Plot image_plot(const std::vector<const EvaluatedImage*>& images, const ErrorKind& error) {
  PlotSeries network{.name = "network", .style = PlotStyle::dots, .opacity = dot_opacity(images.size())},
      mean{.name = "train mean", .style = PlotStyle::dots, .opacity = dot_opacity(images.size())};
  for (const EvaluatedImage* image : images) {
    const double hfov_deg = degrees(hfov_rad(image->image.truth.pinhole));
    if (const auto value = error.of_image(image->network)) network.points.emplace_back(hfov_deg, *value);
    if (const auto value = error.of_image(image->training_mean)) mean.points.emplace_back(hfov_deg, *value);
  }
  return {.title = fmt::format("{} of each image", error.title),
          .x_label = "true H-FOV, degrees",
          .y_label = error.unit,
          .series = {std::move(network), std::move(mean)}};
}

}  // namespace

std::string error_section(const Evaluation& evaluation) {
  const std::vector<const EvaluatedImage*> images = plotted_images(evaluation);
  std::vector<Plot> plots;
  for (const ErrorKind& error : error_kinds)
    plots.push_back(bin_plot(evaluation, error, "H-FOV", "true H-FOV, degrees"));
  for (const ErrorKind& error : error_kinds)
    plots.push_back(bin_plot(evaluation, error, "lens", "true k1, scaled"));
  for (const ErrorKind& error : error_kinds) plots.push_back(image_plot(images, error));
  return "<section id=\"errors\"><h2>Errors by H-FOV and by strength of the lens</h2>\n<p>Means over the "
         "images of a bin, each shown at its middle, beside those of always predicting the training mean. "
         "Bars are 95 % intervals by bootstrap over places.</p>\n" +
         to_svg(plots, 2, {.clip = "errors_plots"}) + "</section>\n";
}

}  // namespace cps
