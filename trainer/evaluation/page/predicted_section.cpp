#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/plot.h"
#include "trainer/evaluation/page/sections.h"
#include "trainer/evaluation/page/shown_images.h"

namespace cps {
namespace {

/// Widened a little, and to a length above 0.
Interval with_margin(const Interval& range) {
  const double margin = range.high > range.low ? .04 * (range.high - range.low) : .5;
  return {range.low - margin, range.high + margin};
}

Plot predicted_against_true(const std::vector<ShownOutputs>& images, int output) {
  PlotSeries bars{.style = PlotStyle::bars, .colour = 0, .opacity = .5 * dot_opacity(images.size())},
      dots{.style = PlotStyle::dots, .colour = 0, .opacity = dot_opacity(images.size())};
  Interval range{INFINITY, -INFINITY};
  for (const ShownOutputs& image : images) {
    const double truth = image.truth[output], predicted = image.predicted[output];
    if (!std::isfinite(predicted)) continue;
    dots.points.emplace_back(truth, predicted);
    range = {std::min({range.low, truth, predicted}), std::max({range.high, truth, predicted})};
    if (!image.deviation) continue;
    const double deviation = (*image.deviation)[output];
    bars.points.emplace_back(truth, predicted - deviation);
    bars.points.emplace_back(truth, predicted + deviation);
  }
  range = dots.points.empty() ? Interval{0, 1} : with_margin(range);
  PlotSeries equal{.points = {{range.low, range.low}, {range.high, range.high}}, .colour = 1};
  return {.title = shown_name(output),
          .x_label = "true",
          .y_label = "predicted",
          .series = {std::move(bars), std::move(dots), std::move(equal)},
          .x_range = range,
          .y_range = range};
}

}  // namespace

std::string predicted_section(const Evaluation& evaluation) {
  std::vector<ShownOutputs> shown;
  for (const EvaluatedImage* image : plotted_images(evaluation)) shown.push_back(shown_outputs(*image));
  std::vector<Plot> plots;
  for (int output = 0; output < output_count; ++output)
    plots.push_back(predicted_against_true(shown, output));
  return fmt::format(
      "<section id=\"predicted\"><h2>Predicted against true</h2>\n<p>A dot per image{}; on the line both are "
      "equal. Coefficients are those of lengths in half diagonals of the image at distance 1: k1 R², k2 R⁴, "
      "k3 R⁶, p R.{}</p>\n{}</section>\n",
      shown.size() < evaluation.images.size()
          ? fmt::format(" ({} of {}, evenly chosen)", shown.size(), evaluation.images.size())
          : "",
      evaluation.coverage ? " A bar is the stated standard deviation to both sides." : "",
      to_svg(plots, 3, {.clip = "predicted_plots"}));
}

}  // namespace cps
