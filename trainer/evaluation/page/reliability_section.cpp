#include <fmt/format.h>

#include <utility>

#include "files/html_page.h"
#include "files/plot.h"
#include "trainer/evaluation/page/sections.h"

namespace cps {
namespace {

/// Shares of the errors within the stated deviations against those of a normal distribution.
Plot reliability_plot(const Coverage& coverage, const char* title, const std::vector<int>& outputs) {
  Plot plot{.title = title,
            .x_label = "share of a normal distribution",
            .y_label = "share of the errors",
            .series = {{.name = "normal", .points = {{0, 0}, {1, 1}}, .colour = 6}},
            .x_range = Interval{0, 1},
            .y_range = Interval{0, 1},
            .has_legend_below = true};
  for (int output : outputs) {
    PlotSeries line{.name = output_names[output], .points = {{0, 0}}, .colour = plot.series.size() - 1};
    for (int point = 0; point < reliability_points; ++point)
      line.points.emplace_back(normal_share(reliability_deviations(point)), coverage.within[point][output]);
    plot.series.push_back(std::move(line));
  }
  return plot;
}

std::vector<std::string> coverage_cells(const std::string& name, double within_one, double within_two,
                                        double scaled_error) {
  return {name, fmt::format("{:.1f} %", 100 * within_one), fmt::format("{:.1f} %", 100 * within_two),
          fmt::format("{:.3g}", scaled_error)};
}

std::string coverage_table(const Coverage& coverage) {
  std::vector<std::vector<std::string>> rows;
  for (int i = 0; i < output_count; ++i)
    rows.push_back(coverage_cells(output_names[i], coverage.within_one[i], coverage.within_two[i],
                                  coverage.scaled_error[i]));
  rows.push_back(coverage_cells("a normal distribution", normal_share(1), normal_share(2), 1));
  return html_table({"errors of", "within one deviation", "within two", "rms error / deviation"}, rows);
}

}  // namespace

std::string reliability_section(const Evaluation& evaluation) {
  if (!evaluation.coverage) return "";
  const Coverage& coverage = *evaluation.coverage;
  const std::vector<Plot> plots{reliability_plot(coverage, "H-FOV and principal point", {0, 6, 7}),
                                reliability_plot(coverage, "distortion", {1, 2, 3, 4, 5})};
  return fmt::format(
      "<section id=\"reliability\"><h2>Reliability of the stated deviations</h2>\n<p>The share of the errors "
      "within .25, .5, … 3 stated standard deviations against that of a normal distribution. Below the line "
      "“normal” the deviations are too small, above it too large. Outputs as published.</p>\n{}{}"
      "</section>\n",
      to_svg(plots, 2, {.clip = "reliability_plots"}), coverage_table(coverage));
}

}  // namespace cps
