#include "renderer/camera_rays.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"

namespace cps {
namespace {

/// The picture with a margin of whole pixels on each side that the filter covers.
Pinhole with_margin(const Pinhole& camera, PixelFilter filter) {
  const int margin = static_cast<int>(std::ceil(filter_radius_px(filter) - 0.5f));
  return oversampled(camera, 1, margin);
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
                  .lens = camera.lens,
                  .ideal_box = {}};
  if (camera.lens) {
    const FrameCertificate proof = certify_frame(*camera.lens, with_margin(pinhole, filter), one_to_one);
    if (!proof.valid()) throw std::runtime_error("lens: not one-to-one on the picture: " + proof.why);
    rays.ideal_box = proof.rectangle;
  }
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
