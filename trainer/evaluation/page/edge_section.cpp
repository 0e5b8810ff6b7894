#include <fmt/format.h>

#include <array>

#include "files/markup.h"
#include "trainer/evaluation/page/edge_strokes.h"
#include "trainer/evaluation/page/picture_svg.h"
#include "trainer/evaluation/page/sections.h"

namespace cps {
namespace {

std::string stroke_path(const Stroke& stroke, double opacity) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke-opacity=\"{:.2f}\"/>\n",
                     stroke.from.x(), stroke.from.y(), stroke.to.x(), stroke.to.y(), opacity);
}

std::string stroke_group(const char* colour, double width_px, const std::string& paths) {
  return fmt::format("<g stroke=\"{}\" stroke-width=\"{:.2f}\">\n{}</g>\n", colour, width_px, paths);
}

std::string edge_drawing(const TrustedEdges& edges) {
  std::array<std::string, edge_families> measured;
  std::string modelled;
  for (const EdgeStroke& stroke : edge_strokes(edges.evidence, edges.model)) {
    measured[stroke.family] += stroke_path(stroke.measured, stroke.opacity);
    if (stroke.modelled) modelled += stroke_path(*stroke.modelled, stroke.opacity);
  }
  const double block = block_px(edges.evidence.edges);
  return stroke_group("#0072b2", .12 * block, measured[0]) +
         stroke_group("#d55e00", .12 * block, measured[1]) + stroke_group("#009e73", .05 * block, modelled);
}

std::string edge_figure(const Evaluation& evaluation, const TrustedEdges& edges) {
  constexpr int width_px = 840;
  const EvaluatedImage& image = evaluation.images[edges.image];
  const std::string error = image.network.reprojection_px
                                ? fmt::format("{:.1f} px", *image.network.reprojection_px)
                                : "none: the prediction is not a camera";
  return fmt::format(
      "<figure>{}<figcaption>{}<br>reprojection error {}, the {} of all</figcaption></figure>\n",
      picture_svg(image.image, width_px, .6, edge_drawing(edges)), escaped(image.image.name), error,
      edges.rank);
}

}  // namespace

std::string edge_section(const Evaluation& evaluation) {
  if (evaluation.edges.empty()) return "";
  std::string html =
      "<section id=\"edges\"><h2>Edges that the network trusts</h2>\n<p>Each stroke is the mean direction of a "
      "block's near-vertical (blue) or near-horizontal (orange) edges. The more opaque it is, the more the "
      "network trusts it: opacity is in proportion to the inverse of the standard deviation that it gives the "
      "direction. The thin green line beside a stroke is the direction of upright edges, or of edges across "
      "the street, by the camera that is fitted to all of them.</p>\n";
  for (const TrustedEdges& edges : evaluation.edges) html += edge_figure(evaluation, edges);
  return html + "</section>\n";
}

}  // namespace cps
