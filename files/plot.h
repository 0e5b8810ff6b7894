#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "numbers/interval.h"

/// Diagrams as SVG, for pages and reports: no fonts or programs needed to make or read them.
namespace cps {

enum class PlotStyle { line, dots };

struct PlotSeries {
  std::string name = {};  ///< for the legend; empty: not in it
  PlotStyle style = PlotStyle::line;
  std::vector<Eigen::Vector2d> points = {};  ///< not finite: a gap
};

/// One diagram. A range that is not given is that of the points.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series = {};
  std::optional<Interval> x_range = {}, y_range = {};
};

/// The outline of a histogram: the density of the values in `bins` equal bins on `range`, relative to all
/// values. Bins ≥ 1, and the range is not empty.
PlotSeries histogram(const std::string& name, std::span<const double> values, Interval range, int bins);

/// Values at round steps (1, 2 or 5 times a power of ten), about `count` of them, inside the range (Heckbert
/// 1990). At least one; `low` < `high`.
std::vector<double> round_ticks(Interval range, int count);

/// The diagrams in rows of `columns`, as an SVG document. The same bytes for the same diagrams.
std::string to_svg(std::span<const Plot> plots, int columns);

}  // namespace cps
