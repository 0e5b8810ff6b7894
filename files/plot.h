#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "numbers/interval.h"

/// Diagrams as SVG. Written by hand so that reports need no plotting program, and the same data give the same
/// bytes.
namespace cps {

/// bars: the points in pairs, each joined by a thin line.
enum class PlotStyle { line, dots, bars };

struct PlotSeries {
  std::string name = {};  ///< shown in the legend unless empty
  PlotStyle style = PlotStyle::line;
  std::vector<Eigen::Vector2d> points = {};  ///< a point that is not finite interrupts the line
  std::optional<std::size_t> colour = {};  ///< place in the palette of seven; without it, the series' number
  double opacity = .5;                     ///< of dots and bars
};

/// One diagram. Without a range, the axis covers the points.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series = {};
  std::optional<Interval> x_range = {}, y_range = {};
  bool has_legend_below = false;  ///< the legend stands at the bottom of the diagram, not at its top
};

/// The size of each diagram in SVG user units, and the name of its clip path, which must differ from every
/// other id of one HTML page.
struct PlotFrame {
  int width = 420, height = 300;
  std::string clip = "frame";
};

/// The outline of a histogram: the density of the values in `bins` equal bins on `range`, so that its area is
/// the share of all values that lie in the range. Needs bins ≥ 1 and range.low < range.high.
PlotSeries histogram(const std::string& name, std::span<const double> values, Interval range, int bins);

/// Multiples of a round step (1, 2 or 5 times a power of ten) inside the range, about `count` of them and at
/// least one (Heckbert 1990). Needs range.low < range.high.
std::vector<double> round_ticks(Interval range, int count);

/// Sets both ranges such that all points are shown and a unit is equally long on both axes: for maps.
void make_scales_equal(Plot& plot, const PlotFrame& frame);

/// An SVG document with the diagrams in rows of `columns`. The same diagrams give the same bytes.
std::string to_svg(std::span<const Plot> plots, int columns, const PlotFrame& frame = {});

}  // namespace cps
