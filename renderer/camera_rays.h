#pragma once

#include "distortion/models/certificate/model_certificate.h"
#include "renderer/camera.h"
#include "renderer/math/color.h"
#include "renderer/math/pixel_filter.h"

namespace cps {

/// The ray of a point of the picture.
struct CameraRay {
  Vec3 direction = {0, 0, 1};  ///< world, unit length
  float pixel_angle = 0;       ///< square root of the solid angle of a pixel there, rad
  bool is_seen = true;         ///< false: the lens shows nothing at that point
};

/// The rays of a camera, through its lens if it has one.
struct CameraRays {
  Vec3 position;
  Eigen::Matrix3f world_from_camera;
  Pinhole pinhole;
  std::optional<Distortion> lens;  ///< a Brown–Conrady lens
  Eigen::AlignedBox2d ideal_box;   ///< on the plane z = 1, where that lens is certified
  std::optional<LensModel> model;  ///< a lens of another family
  RayRegion region;                ///< rays on which that lens is certified
};

/// Throws std::runtime_error in one line: a size or focal length that is not positive; a lens of a plane
/// family (brown_conrady, rational) that cannot be proved one-to-one on the picture and the margin around it
/// that the filter covers; a lens of another family that is proved nowhere.
CameraRays make_camera_rays(const Camera& camera, PixelFilter filter);

/// A pixel's centre, from which the inverse for its rays starts.
struct CameraPixel {
  Eigen::Vector2d distorted, ideal;      ///< the centre on z = 1, before and after undistortion
  Eigen::Matrix2d ideal_from_distorted;  ///< Jacobian there
};
CameraPixel camera_pixel(const CameraRays& rays, int x, int y);

/// The ray `offset_px` pixels from the centre. Inverts a Brown–Conrady lens by Newton steps from the centre,
/// one of another family by unproject().
CameraRay camera_ray(const CameraRays& rays, const CameraPixel& pixel, const Eigen::Vector2f& offset_px);

}  // namespace cps
