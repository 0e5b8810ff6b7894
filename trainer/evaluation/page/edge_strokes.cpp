#include "trainer/evaluation/page/edge_strokes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numbers/quantile.h"

namespace cps {
namespace {

using Eigen::Vector2d;

constexpr double min_opacity = .05;

/// In parts of block_px(): of a stroke, and how far the model's stands beside the measured one.
constexpr double stroke_length = .75, model_distance = .16;

Stroke stroke_through(const Vector2d& middle, const Vector2d& direction, double length) {
  const Vector2d half = .5 * length * direction.normalized();
  return {middle - half, middle + half};
}

/// The weight that is drawn opaque.
double opaque_weight(const EdgeBlocks& edges) {
  std::vector<double> weights;
  for (float weight : edges.weight)
    if (weight > 0) weights.push_back(weight);
  return quantile(std::move(weights), .95);
}

}  // namespace

Vector2d edge_direction(int family, double tilt) {
  return family == 0 ? Vector2d(-tilt, 1) : Vector2d(1, -tilt);
}

double block_px(const EdgeBlocks& edges) {
  return std::min(static_cast<double>(edges.picture.width) / edges.grid.width,
                  static_cast<double>(edges.picture.height) / edges.grid.height);
}

std::vector<EdgeStroke> edge_strokes(const FrameEvidence& frame, const TiltModel& model) {
  const EdgeBlocks& edges = frame.edges;
  const Vector2d size(edges.picture.width, edges.picture.height);
  const double block = block_px(edges), opaque = opaque_weight(edges);
  std::vector<EdgeStroke> strokes;
  std::size_t i = 0;
  for (int family = 0; family < edge_families; ++family)
    for (double y : frame.centres.y)
      for (double x : frame.centres.x) {
        const std::size_t at = i++;
        const double weight = edges.weight[at];
        const double opacity = weight > 0 ? std::min(1., std::sqrt(weight / opaque)) : 0;
        if (opacity < min_opacity) continue;
        const Vector2d middle = .5 * (size + size.norm() * Vector2d(x, y));
        const Vector2d measured = edge_direction(family, edges.weighted_tilt[at] / weight);
        EdgeStroke stroke{family, stroke_through(middle, measured, stroke_length * block), std::nullopt,
                          opacity};
        if (model.has_tilt[at]) {
          const Vector2d modelled = edge_direction(family, model.tilt[at]),
                         beside = Vector2d(modelled.y(), -modelled.x()).normalized();
          stroke.modelled =
              stroke_through(middle + model_distance * block * beside, modelled, stroke_length * block);
        }
        strokes.push_back(stroke);
      }
  return strokes;
}

}  // namespace cps
