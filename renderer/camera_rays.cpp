#include "renderer/camera_rays.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/models/inverse/unproject.h"

namespace cps {
namespace {

/// The picture with a margin of whole pixels on each side that the filter covers.
Pinhole with_margin(const Pinhole& camera, PixelFilter filter) {
  const int margin = static_cast<int>(std::ceil(filter_radius_px(filter) - 0.5f));
  return oversampled(camera, 1, margin);
}

void add_brown_conrady(CameraRays& rays, const Distortion& lens, PixelFilter filter) {
  const FrameCertificate proof = certify_frame(lens, with_margin(rays.pinhole, filter), one_to_one);
  if (!proof.valid()) throw std::runtime_error("lens: not one-to-one on the picture: " + proof.why);
  rays.lens = lens;
  rays.ideal_box = proof.rectangle;
}

void add_model(CameraRays& rays, const LensModel& lens, PixelFilter filter) {
  const ModelCertificate proof = certify_frame({"", with_margin(rays.pinhole, filter), lens}, one_to_one);
  const bool is_of_the_plane = std::holds_alternative<RationalLens>(lens);
  if (!proof.valid && (is_of_the_plane || !(proof.region.max_angle_rad > 0)))
    throw std::runtime_error("lens: not one-to-one on the picture: " + proof.why);
  rays.model = lens;
  rays.region = proof.region;
}

/// camera_ray() through a lens of another family than Brown–Conrady.
CameraRay model_ray(const CameraRays& rays, const Eigen::Vector2d& distorted) {
  const auto seen = unproject_with_jacobian(*rays.model, rays.region, distorted);
  if (!seen) return {.is_seen = false};
  CameraRay ray;
  ray.direction = rays.world_from_camera * seen->ray.cast<float>();
  const double solid_angle = seen->jacobian.col(0).cross(seen->jacobian.col(1)).norm();
  ray.pixel_angle = static_cast<float>(std::sqrt(solid_angle / (rays.pinhole.fx * rays.pinhole.fy)));
  return ray;
}

}  // namespace

CameraRays make_camera_rays(const Camera& camera, PixelFilter filter) {
  const Pinhole& pinhole = camera.pinhole;
  if (pinhole.width < 1 || pinhole.height < 1)
    throw std::runtime_error("camera: width and height must be at least 1");
  if (!(pinhole.fx > 0 && pinhole.fy > 0)) throw std::runtime_error("camera: fx and fy must be positive");
  CameraRays rays{.position = camera.world_from_camera.translation().cast<float>(),
                  .world_from_camera = camera.world_from_camera.linear().cast<float>(),
                  .pinhole = pinhole,
                  .lens = {},
                  .ideal_box = {},
                  .model = {},
                  .region = {}};
  if (!camera.lens) return rays;
  if (const auto* lens = std::get_if<Distortion>(&*camera.lens))
    add_brown_conrady(rays, *lens, filter);
  else
    add_model(rays, *camera.lens, filter);
  return rays;
}

CameraPixel camera_pixel(const CameraRays& rays, int x, int y) {
  CameraPixel pixel;
  pixel.distorted = to_plane(rays.pinhole, {x, y});
  pixel.ideal = pixel.distorted;
  if (rays.lens) {
    // The certificate guarantees that an inverse exists.
    pixel.ideal = undistort(*rays.lens, rays.ideal_box, pixel.distorted).value();
    pixel.ideal_from_distorted = distortion_jacobian(*rays.lens, pixel.ideal).inverse();
  }
  return pixel;
}

CameraRay camera_ray(const CameraRays& rays, const CameraPixel& pixel, const Eigen::Vector2f& offset_px) {
  const Eigen::Vector2d offset(offset_px.x() / rays.pinhole.fx, offset_px.y() / rays.pinhole.fy);
  if (rays.model) return model_ray(rays, pixel.distorted + offset);
  Eigen::Vector2d ideal = pixel.ideal + offset;
  double area = 1 / (rays.pinhole.fx * rays.pinhole.fy);  // of a pixel on the ideal plane
  if (rays.lens) {
    const Eigen::Vector2d guess = pixel.ideal + pixel.ideal_from_distorted * offset;
    ideal = undistort_near(*rays.lens, rays.ideal_box, pixel.distorted + offset, guess).value();
    area /= distortion_jacobian(*rays.lens, ideal).determinant();
  }
  CameraRay ray;
  const double cosine = 1 / std::sqrt(1 + ideal.squaredNorm());
  ray.direction =
      rays.world_from_camera * Vec3(static_cast<float>(ideal.x() * cosine),
                                    static_cast<float>(ideal.y() * cosine), static_cast<float>(cosine));
  // A pixel of area A on the plane covers A cos³ sr.
  ray.pixel_angle = static_cast<float>(std::sqrt(area * cosine * cosine * cosine));
  return ray;
}

}  // namespace cps
