#include "distortion/crop/true_fov.h"

#include <algorithm>
#include <cmath>

#include "distortion/inverse/inverse.h"

namespace cps {

std::optional<TrueFov> true_fov(const Distortion& lens, const Pinhole& camera,
                                const Eigen::AlignedBox2d& box) {
  const double left = -0.5, top = -0.5, right = camera.width - 0.5, bottom = camera.height - 0.5;
  const auto angle = [&](const Eigen::Vector2d& pixel_a,
                         const Eigen::Vector2d& pixel_b) -> std::optional<double> {
    const auto a = undistort(lens, box, to_plane(camera, pixel_a)),
               b = undistort(lens, box, to_plane(camera, pixel_b));
    if (!a || !b) return std::nullopt;
    const Eigen::Vector3d ray_a = a->homogeneous(), ray_b = b->homogeneous();
    return std::atan2(ray_a.cross(ray_b).norm(), ray_a.dot(ray_b));
  };
  const auto horizontal = angle({left, camera.cy}, {right, camera.cy});
  const auto vertical = angle({camera.cx, top}, {camera.cx, bottom});
  const auto falling = angle({left, top}, {right, bottom}), rising = angle({left, bottom}, {right, top});
  if (!horizontal || !vertical || !falling || !rising) return std::nullopt;
  return TrueFov{*horizontal, *vertical, std::max(*falling, *rising)};
}

}  // namespace cps
