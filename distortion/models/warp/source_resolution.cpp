#include "distortion/models/warp/source_resolution.h"

#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>

#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"

namespace cps {
namespace {

/// The smallest value of `of(ray and its derivative by the pixel)` over a grid of the frame's points that are
/// seen.
template <typename Value>
double smallest_on_frame(const ModelCamera& camera, const RayRegion& region, const Value& of) {
  constexpr int steps = 32;
  const Pinhole& pinhole = camera.pinhole;
  double smallest = std::numeric_limits<double>::infinity();
  for (int row = 0; row <= steps; ++row)
    for (int column = 0; column <= steps; ++column) {
      const Eigen::Vector2d pixel(-0.5 + pinhole.width * (static_cast<double>(column) / steps),
                                  -0.5 + pinhole.height * (static_cast<double>(row) / steps));
      auto seen = unproject_with_jacobian(camera.lens, region, to_plane(pinhole, pixel));
      if (!seen) continue;
      seen->jacobian.col(0) /= pinhole.fx;
      seen->jacobian.col(1) /= pinhole.fy;
      smallest = std::min(smallest, of(*seen));
    }
  return smallest;
}

}  // namespace

double fewest_source_px(const ModelCamera& source, const RayRegion& source_region, const ModelCamera& output,
                        const RayRegion& output_region) {
  return smallest_on_frame(output, output_region, [&](const UnprojectedPoint& seen) {
    if (!contains(source_region, source.lens, seen.ray)) return std::numeric_limits<double>::infinity();
    Eigen::Matrix2d moved = project(source.lens, seen.ray).jacobian * seen.jacobian;
    moved.row(0) *= source.pinhole.fx;
    moved.row(1) *= source.pinhole.fy;
    return Eigen::JacobiSVD<Eigen::Matrix2d>(moved).singularValues()[1];
  });
}

double fewest_panorama_px(const Panorama& panorama, const ModelCamera& output, const RayRegion& region) {
  const double px_per_rad = panorama.width / (2 * std::numbers::pi);
  return smallest_on_frame(output, region, [&](const UnprojectedPoint& seen) {
    return px_per_rad * Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>>(seen.jacobian).singularValues()[1];
  });
}

}  // namespace cps
