#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cps {

/// An ideal camera. The centre of the top-left pixel is (0, 0); the frame is [−.5, W−.5] × [−.5, H−.5].
struct Pinhole {
  int width = 0, height = 0;  ///< pixels
  double fx = 0, fy = 0;      ///< focal lengths, pixels
  double cx = 0, cy = 0;      ///< principal point, pixels
  bool operator==(const Pinhole&) const = default;
};

/// Square-pixelled camera with a centred principal point ((W−1)/2, (H−1)/2) and this horizontal field of
/// view.
Pinhole pinhole_from_hfov(int width, int height, double hfov_rad);

/// The H-FOV as labels have it, 2·atan(W / 2fx), radians.
double hfov_rad(const Pinhole& camera);

/// The same camera with every pixel split into `oversampling`² and `pad` of those added on each side.
/// cx maps to oversampling·(cx + .5) − .5 + pad. If oversampling times the size is not a whole number, the
/// size is rounded up and the excess is split evenly between both sides.
Pinhole oversampled(const Pinhole& camera, double oversampling, int pad = 0);

/// Pixel → point on the plane z = 1, and back.
Eigen::Vector2d to_plane(const Pinhole& camera, const Eigen::Vector2d& pixel);
Eigen::Vector2d to_pixel(const Pinhole& camera, const Eigen::Vector2d& on_plane);

/// The part of the plane z = 1 that the whole frame (pixel areas, not centres) sees.
Eigen::AlignedBox2d frame_on_plane(const Pinhole& camera);

}  // namespace cps
