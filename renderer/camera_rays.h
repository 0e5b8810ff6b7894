#pragma once

#include "renderer/camera.h"
#include "renderer/math/color.h"
#include "renderer/math/pixel_filter.h"

namespace cps {

/// Where a point of the picture looks.
struct CameraRay {
  Vec3 direction = {0, 0, 1};  ///< world, unit length
  float pixel_angle = 0;       ///< square root of the solid angle that a pixel covers there, rad
};

/// The rays of a camera, through its lens if it has one.
struct CameraRays {
  Vec3 position;
  Eigen::Matrix3f world_from_camera;
  Pinhole pinhole;
  std::optional<Distortion> lens;
  Eigen::AlignedBox2d ideal_box;  ///< on z = 1, where the lens is certified
};

/// Throws std::runtime_error in one line: sizes and focal lengths that are not positive; a lens that cannot
/// be proved one-to-one on the picture and the margin that the filter reaches into.
CameraRays make_camera_rays(const Camera& camera, PixelFilter filter);

/// A pixel's centre, from which its rays are found.
struct CameraPixel {
  Eigen::Vector2d distorted, ideal;      ///< of the centre on z = 1
  Eigen::Matrix2d ideal_from_distorted;  ///< Jacobian there
};
CameraPixel camera_pixel(const CameraRays& rays, int x, int y);

/// The ray `offset` pixels from the centre, by inverting the lens for it alone.
CameraRay camera_ray(const CameraRays& rays, const CameraPixel& pixel, const Eigen::Vector2f& offset_px);

}  // namespace cps
