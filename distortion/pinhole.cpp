#include "distortion/pinhole.h"

#include <cmath>

namespace cps {

Pinhole pinhole_from_hfov(int width, int height, double hfov_rad) {
  const double focal = 0.5 * width / std::tan(0.5 * hfov_rad);
  return {width, height, focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)};
}

double hfov_rad(const Pinhole& camera) {
  return 2 * std::atan(0.5 * camera.width / camera.fx);
}

Pinhole oversampled(const Pinhole& camera, double oversampling, int pad) {
  const int width = static_cast<int>(std::ceil(oversampling * camera.width));
  const int height = static_cast<int>(std::ceil(oversampling * camera.height));
  const double extra_x = 0.5 * (width - oversampling * camera.width);
  const double extra_y = 0.5 * (height - oversampling * camera.height);
  return {width + 2 * pad,
          height + 2 * pad,
          oversampling * camera.fx,
          oversampling * camera.fy,
          oversampling * (camera.cx + 0.5) - 0.5 + pad + extra_x,
          oversampling * (camera.cy + 0.5) - 0.5 + pad + extra_y};
}

Eigen::Vector2d to_plane(const Pinhole& camera, const Eigen::Vector2d& pixel) {
  return {(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy};
}

Eigen::Vector2d to_pixel(const Pinhole& camera, const Eigen::Vector2d& on_plane) {
  return {camera.fx * on_plane.x() + camera.cx, camera.fy * on_plane.y() + camera.cy};
}

Eigen::AlignedBox2d frame_on_plane(const Pinhole& camera) {
  return {to_plane(camera, {-0.5, -0.5}), to_plane(camera, {camera.width - 0.5, camera.height - 0.5})};
}

}  // namespace cps
