#include "dataset/report/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dataset/report/text.h"
#include "files/markup.h"

namespace cps {
namespace {

constexpr int bins = 24;
constexpr std::size_t limits_colour = 6;  // black: in no part's colour

/// Covers all values and the limits. Not empty.
Interval shown_range(const DistributionSummary& summary, const std::optional<Interval>& limits) {
  Interval range{summary.min, summary.max};
  if (limits) range = {std::min(range.low, limits->low), std::max(range.high, limits->high)};
  const double length = range.high - range.low;
  const double margin =
      length > 1e-9 * std::abs(range.high) ? 0.02 * length : std::max(0.5, 0.01 * std::abs(range.high));
  return {range.low - margin, range.high + margin};
}

/// The histogram's outline as shares of the part's images per bin, in percent.
PlotSeries shares(const Distribution& distribution, Part part, Interval range) {
  const auto p = static_cast<std::size_t>(part);
  PlotSeries outline = histogram(to_string(part), distribution.values[p], range, bins);
  for (Eigen::Vector2d& point : outline.points) point.y() *= 100 * (range.high - range.low) / bins;
  outline.colour = p;
  return outline;
}

PlotSeries limit_lines(Interval limits, double top) {
  return {.name = "limits",
          .points = {{limits.low, 0}, {limits.low, top}, {NAN, NAN}, {limits.high, 0}, {limits.high, top}},
          .colour = limits_colour};
}

std::string caption(const Distribution& distribution, const DistributionSummary& summary) {
  std::string text =
      fmt::format("{} images: {:.6g} … {:.6g}, mean {:.6g}, standard deviation {:.4g}",
                  grouped(summary.count), summary.min, summary.max, summary.mean, summary.standard_deviation);
  if (distribution.limits)
    text += fmt::format("; limits {:.6g} … {:.6g}", distribution.limits->low, distribution.limits->high);
  if (summary.outside > 0) text += "; " + grouped(summary.outside) + " outside";
  if (!distribution.note.empty()) text += ". " + distribution.note;
  return text;
}

}  // namespace

DistributionSummary summary_of(const Distribution& distribution) {
  DistributionSummary summary{.min = INFINITY, .max = -INFINITY};
  double sum = 0, squares = 0;
  for (const std::vector<double>& part : distribution.values)
    for (double value : part) {
      ++summary.count;
      sum += value;
      summary.min = std::min(summary.min, value);
      summary.max = std::max(summary.max, value);
      if (!distribution.limits) continue;
      const auto [low, high] = *distribution.limits;
      const double rounding = 1e-9 * std::max(std::abs(low), std::abs(high));
      if (value < low - rounding || value > high + rounding) ++summary.outside;
    }
  if (summary.count == 0) return {};
  summary.mean = sum / static_cast<double>(summary.count);
  for (const std::vector<double>& part : distribution.values)
    for (double value : part) squares += (value - summary.mean) * (value - summary.mean);
  summary.standard_deviation = std::sqrt(squares / static_cast<double>(summary.count));
  return summary;
}

Plot distribution_plot(const Distribution& distribution) {
  const Interval range = shown_range(summary_of(distribution), distribution.limits);
  Plot plot{.title = distribution.name,
            .x_label = distribution.unit,
            .y_label = "% of the part's images",
            .x_range = range};
  double top = 0;
  for (Part part : {Part::train, Part::val, Part::test}) {
    if (distribution.values[static_cast<std::size_t>(part)].empty()) continue;
    plot.series.push_back(shares(distribution, part, range));
    for (const Eigen::Vector2d& point : plot.series.back().points) top = std::max(top, point.y());
  }
  plot.y_range = Interval{0, 1.3 * top};  // room for the legend
  if (distribution.limits) plot.series.push_back(limit_lines(*distribution.limits, plot.y_range->high));
  return plot;
}

std::string to_html(const Distribution& distribution, std::size_t number) {
  const DistributionSummary summary = summary_of(distribution);
  if (summary.count == 0) return "";
  const Plot plot = distribution_plot(distribution);
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                     to_svg({&plot, 1}, 1, {.clip = fmt::format("frame{}", number)}),
                     escaped(caption(distribution, summary)));
}

}  // namespace cps
