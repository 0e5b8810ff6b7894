#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dataset/report/label_distributions.h"
#include "dataset/report/sections.h"
#include "files/plot.h"
#include "numbers/angles.h"

namespace cps {
namespace {

constexpr std::size_t max_lenses_plotted = 1000;

std::string diagrams(const std::vector<Distribution>& distributions, std::size_t first) {
  std::string html = "<div class=\"diagrams\">\n";
  for (std::size_t i = 0; i < distributions.size(); ++i) html += to_html(distributions[i], first + i);
  return html + "</div>\n";
}

/// One coefficient against H-FOV: a dot per lens, and a line over the interval that it was drawn from.
Plot coefficient_plot(const std::vector<const Label*>& labels, std::size_t key) {
  Plot plot{.title = lens_keys[key], .x_label = "H-FOV, degrees", .y_label = ""};
  PlotSeries limits{.colour = 6};
  std::array<PlotSeries, 4> dots;
  for (const Label* label : labels) {
    const double hfov_deg = degrees(hfov_rad(label->camera));
    const Distortion& lens = label->distortion;
    const double value[] = {lens.k1, lens.k2, lens.k3, lens.p1, lens.p2};
    dots[static_cast<std::size_t>(label->part)].points.emplace_back(hfov_deg, value[key]);
    if (const auto& drawn = label->limits[key])
      limits.points.insert(limits.points.end(),
                           {{hfov_deg, drawn->low}, {hfov_deg, drawn->high}, {NAN, NAN}});
  }
  if (!limits.points.empty()) plot.series.push_back(std::move(limits));
  for (std::size_t p = 0; p < dots.size(); ++p) {
    if (dots[p].points.empty()) continue;
    dots[p].name = to_string(static_cast<Part>(p));
    dots[p].style = PlotStyle::dots;
    dots[p].colour = p;
    plot.series.push_back(std::move(dots[p]));
  }
  return plot;
}

std::string coefficients(const Dataset& dataset) {
  std::vector<const Label*> labels;
  for (const DatasetGroup& group : dataset.groups)
    if (!is_undistorted(group.label)) labels.push_back(&group.label);
  if (labels.empty()) return "";
  std::string html = fmt::format(
      "<h3>Coefficients against H-FOV</h3>\n<p>A dot per lens{}; a line spans the interval that "
      "the coefficient was drawn from, where its label names one.</p>\n<div class=\"diagrams\">\n",
      labels.size() > max_lenses_plotted
          ? fmt::format(" ({} of {}, evenly chosen)", max_lenses_plotted, labels.size())
          : "");
  const std::size_t shown = std::min(labels.size(), max_lenses_plotted);
  for (std::size_t i = 0; i < shown; ++i) labels[i] = labels[i * labels.size() / shown];
  labels.resize(shown);
  for (std::size_t key = 0; key < 5; ++key) {
    const Plot plot = coefficient_plot(labels, key);
    html += "<figure>" + to_svg({&plot, 1}, 1, {.clip = fmt::format("coefficient{}", key)}) + "</figure>\n";
  }
  return html + "</div>\n";
}

}  // namespace

std::string label_section(const DatasetSurvey& survey) {
  std::string html =
      "<section id=\"labels\"><h2>Labels</h2>\n<p>Every image counts once. The numbers of lenses leave out "
      "images without a lens.</p>\n" +
      diagrams(survey.labels, 0) + coefficients(survey.files.dataset);
  if (survey.frames)
    html += "<h3>Poses, exposure and sensor</h3>\n" +
            diagrams(survey.frames->distributions, survey.labels.size());
  return html + "</section>\n";
}

}  // namespace cps
