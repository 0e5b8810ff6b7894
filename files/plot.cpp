#include "files/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "files/markup.h"

namespace cps {
namespace {

constexpr int left = 62, right = 14, top = 30, bottom = 44;  ///< margins of a diagram, in SVG user units
constexpr std::array colours = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7",
    "#e69f00", "#56b4e9", "#000000"};  ///< distinct for colour-blind readers too (Okabe and Ito 2008)

Interval range_of(const Plot& plot, int axis) {
  if (const auto& given = axis == 0 ? plot.x_range : plot.y_range) return *given;
  Interval range{INFINITY, -INFINITY};
  for (const PlotSeries& series : plot.series)
    for (const Eigen::Vector2d& point : series.points)
      if (point.allFinite()) range = {std::min(range.low, point[axis]), std::max(range.high, point[axis])};
  if (!(range.low <= range.high)) return {0, 1};
  if (range.low == range.high) return {range.low - 0.5, range.high + 0.5};
  const double margin = axis == 0 ? 0 : 0.05 * (range.high - range.low);
  return {range.low - margin, range.high + margin};
}

/// Maps a diagram's values to positions on the page.
struct Axes {
  Interval x, y;
  const PlotFrame& page;
  int width() const { return page.width - left - right; }  ///< inside the margins
  int height() const { return page.height - top - bottom; }
  double page_x(double value) const { return left + (value - x.low) / (x.high - x.low) * width(); }
  double page_y(double value) const {
    return page.height - bottom - (value - y.low) / (y.high - y.low) * height();
  }
  bool shows(const Eigen::Vector2d& p) const {
    return p.x() >= x.low && p.x() <= x.high && p.y() >= y.low && p.y() <= y.high;
  }
};

std::string text(double x, double y, const char* anchor, const std::string& what,
                 const std::string& more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     escaped(what));
}

std::string frame(const Plot& plot, const Axes& axes) {
  std::string svg, grid;
  for (double tick : round_ticks(axes.x, 6)) {
    grid += fmt::format("M{:.1f} {}V{}", axes.page_x(tick), top, top + axes.height());
    svg += text(axes.page_x(tick), top + axes.height() + 15, "middle", fmt::format("{:g}", tick));
  }
  for (double tick : round_ticks(axes.y, 6)) {
    grid += fmt::format("M{} {:.1f}H{}", left, axes.page_y(tick), left + axes.width());
    svg += text(left - 5, axes.page_y(tick) + 4, "end", fmt::format("{:g}", tick));
  }
  const double middle_x = left + 0.5 * axes.width(), middle_y = top + 0.5 * axes.height();
  svg += text(middle_x, axes.page.height - 8, "middle", plot.x_label);
  svg += text(0, 0, "middle", plot.y_label,
              fmt::format(" transform=\"translate(14 {:.1f}) rotate(-90)\"", middle_y));
  svg += text(middle_x, 18, "middle", plot.title, " font-weight=\"bold\"");
  return fmt::format(
             "<path d=\"{}\" stroke=\"#ddd\"/>\n<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
             "fill=\"none\" stroke=\"#888\"/>\n",
             grid, left, top, axes.width(), axes.height()) +
         svg;
}

/// The SVG viewer clips lines at the frame; dots outside it are left out here.
std::string curve(const PlotSeries& series, const Axes& axes, const char* colour) {
  std::string path;
  bool pen_down = false;
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const Eigen::Vector2d& point = series.points[i];
    const bool dot = series.style == PlotStyle::dots;
    if (series.style == PlotStyle::bars && i % 2 == 0) pen_down = false;
    if (!point.allFinite() || (dot && !axes.shows(point))) {
      pen_down = false;
      continue;
    }
    path += fmt::format("{}{:.1f} {:.1f}{}", !dot && pen_down ? "L" : "M", axes.page_x(point.x()),
                        axes.page_y(point.y()), dot ? "h0" : "");
    pen_down = true;
  }
  if (series.style == PlotStyle::dots)
    return fmt::format(
        "<path d=\"{}\" stroke=\"{}\" stroke-width=\"2.4\" stroke-linecap=\"round\" "
        "stroke-opacity=\"{:.2g}\"/>\n",
        path, colour, series.opacity);
  if (series.style == PlotStyle::bars)
    return fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-opacity=\"{:.2g}\" clip-path=\"url(#{})\"/>\n",
                       path, colour, series.opacity, axes.page.clip);
  return fmt::format(
      "<path d=\"{}\" stroke=\"{}\" stroke-width=\"1.6\" fill=\"none\" "
      "clip-path=\"url(#{})\"/>\n",
      path, colour, axes.page.clip);
}

std::string diagram(const Plot& plot, const PlotFrame& page) {
  const Axes axes{range_of(plot, 0), range_of(plot, 1), page};
  std::string svg = frame(plot, axes);
  const auto named =
      std::ranges::count_if(plot.series, [](const PlotSeries& series) { return !series.name.empty(); });
  double legend_y = top + 15;
  if (plot.has_legend_below) legend_y = top + axes.height() + 7 - 15 * static_cast<double>(named);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const char* colour = colours[plot.series[i].colour.value_or(i) % colours.size()];
    svg += curve(plot.series[i], axes, colour);
    if (plot.series[i].name.empty()) continue;
    svg +=
        text(left + axes.width() - 6, legend_y, "end", plot.series[i].name,
             fmt::format(" fill=\"{}\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"", colour));
    legend_y += 15;
  }
  return svg;
}

}  // namespace

PlotSeries histogram(const std::string& name, std::span<const double> values, Interval range, int bins) {
  std::vector<int> counts(bins, 0);
  const double bin_width = (range.high - range.low) / bins;
  for (double value : values)
    if (value >= range.low && value < range.high)
      ++counts[std::min(bins - 1, static_cast<int>((value - range.low) / bin_width))];
  PlotSeries outline{.name = name, .style = PlotStyle::line, .points = {{range.low, 0}}};
  for (int bin = 0; bin < bins; ++bin) {
    const double density = counts[bin] / (bin_width * std::max<std::size_t>(1, values.size()));
    outline.points.emplace_back(range.low + bin * bin_width, density);
    outline.points.emplace_back(range.low + (bin + 1) * bin_width, density);
  }
  outline.points.emplace_back(range.high, 0);
  return outline;
}

std::vector<double> round_ticks(Interval range, int count) {
  const double rough = (range.high - range.low) / count, power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (double factor : {5.0, 2.0, 1.0})
    if (factor * power >= 0.999 * rough) step = factor * power;
  std::vector<double> ticks;
  for (double i = std::ceil(range.low / step - 1e-9); i * step <= range.high + 1e-9 * step; ++i)
    ticks.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

void make_scales_equal(Plot& plot, const PlotFrame& frame) {
  Interval x = range_of(plot, 0), y = range_of(plot, 1);
  const Axes axes{x, y, frame};
  const double unit = std::max((x.high - x.low) / axes.width(), (y.high - y.low) / axes.height());
  const auto widen = [](Interval& range, double length) {
    const double middle = 0.5 * (range.low + range.high);
    range = {middle - 0.5 * length, middle + 0.5 * length};
  };
  widen(x, unit * axes.width());
  widen(y, unit * axes.height());
  plot.x_range = x;
  plot.y_range = y;
}

std::string to_svg(std::span<const Plot> plots, int columns, const PlotFrame& frame) {
  const int rows = (static_cast<int>(plots.size()) + columns - 1) / columns;
  const int page_width = frame.width * std::min(columns, static_cast<int>(plots.size()));
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<clipPath id=\"{6}\"><rect x=\"{2}\" y=\"{3}\" "
      "width=\"{4}\" height=\"{5}\"/></clipPath>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      page_width, frame.height * rows, left, top, frame.width - left - right, frame.height - top - bottom,
      frame.clip);
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
    svg += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", column * frame.width,
                       row * frame.height, diagram(plots[i], frame));
  }
  return svg + "</svg>\n";
}

}  // namespace cps
