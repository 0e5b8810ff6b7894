#include <fmt/format.h>

#include <algorithm>

#include "files/html_page.h"
#include "files/markup.h"
#include "trainer/evaluation/page/lens_grid.h"
#include "trainer/evaluation/page/picture_svg.h"
#include "trainer/evaluation/page/sections.h"
#include "trainer/evaluation/page/shown_images.h"

namespace cps {
namespace {

std::string grid_path(const std::vector<GridCurve>& lines, const char* colour) {
  std::string path;
  for (const GridCurve& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      path += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", line[i].x(), line[i].y());
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" vector-effect=\"non-scaling-stroke\"/>\n",
                     path, colour);
}

/// The straight grid that the true camera sees, as it and the predicted camera show it.
std::string grid_drawing(const EvaluatedImage& image) {
  Eigen::AlignedBox2d extent;
  for (const Eigen::Vector2d& ideal : image.image.rays->ideal) extent.extend(ideal);
  const CalibratedCamera& truth = image.image.truth;
  std::string drawing = grid_path(lens_grid(truth, extent), "#0072b2");
  if (const auto predicted =
          to_camera(image.predicted, TargetSpace::raw, truth.pinhole.width, truth.pinhole.height))
    drawing += grid_path(lens_grid(*predicted, extent), "#d55e00");
  return drawing;
}

std::string number_table(const ShownOutputs& shown) {
  std::vector<std::string> header{"", "true", "predicted"};
  if (shown.deviation) header.push_back("deviation");
  std::vector<std::vector<std::string>> rows;
  for (int i = 0; i < output_count; ++i) {
    rows.push_back(
        {shown_name(i), fmt::format("{:.4f}", shown.truth[i]), fmt::format("{:.4f}", shown.predicted[i])});
    if (shown.deviation) rows.back().push_back(fmt::format("{:.4f}", (*shown.deviation)[i]));
  }
  return html_table(header, rows);
}

std::string failure_figure(const EvaluatedImage& image) {
  constexpr int width_px = 420;
  const std::string error = image.network.reprojection_px
                                ? fmt::format("reprojection error {:.1f} px", *image.network.reprojection_px)
                                : "the prediction is not a camera";
  return fmt::format("<figure>{}<figcaption>{}<br>{}{}</figcaption></figure>\n",
                     picture_svg(image.image, width_px, 1, grid_drawing(image)), escaped(image.image.name),
                     error, number_table(shown_outputs(image)));
}

}  // namespace

std::string failure_section(const Evaluation& evaluation) {
  constexpr std::size_t max_shown = 12;
  const std::vector<int> order = by_reprojection_error(evaluation.images);
  std::string html =
      "<section id=\"failures\"><h2>Worst images</h2>\n<p>Those with the largest reprojection errors. The "
      "lines are one straight grid in space: as the true camera shows it (blue), and as the predicted one "
      "would (orange), both as far as their lenses are one-to-one.</p>\n";
  for (std::size_t i = 0; i < std::min(max_shown, order.size()); ++i)
    html += failure_figure(evaluation.images[order[order.size() - 1 - i]]);
  return html + "</section>\n";
}

}  // namespace cps
