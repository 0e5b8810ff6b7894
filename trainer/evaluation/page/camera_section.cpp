#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "files/plot.h"
#include "trainer/evaluation/page/sections.h"

namespace cps {

std::string camera_section(const Evaluation& evaluation) {
  if (evaluation.cameras.empty()) return "";
  PlotSeries dots{.style = PlotStyle::dots, .colour = 0, .opacity = 1};
  double end = 0;
  for (const CameraEvaluation& camera : evaluation.cameras) {
    const CameraError& error = camera.reprojection_px;
    dots.points.emplace_back(error.single_mean, error.joint);
    if (dots.points.back().allFinite()) end = std::max(end, dots.points.back().maxCoeff());
  }
  const std::vector<Plot> plots{{.title = "reprojection error of each camera",
                                 .x_label = "mean of its single images, pixels",
                                 .y_label = "all images together, pixels",
                                 .series = {{.points = {{0, 0}, {end, end}}, .colour = 1}, std::move(dots)}}};
  return fmt::format(
      "<section id=\"cameras\"><h2>All images of a camera together</h2>\n<p>A dot per camera; below the line the "
      "joint fit is better than its images on their own.</p>\n{}</section>\n",
      to_svg(plots, 1, {.clip = "cameras_plots"}));
}

}  // namespace cps
