#include "dataset/dense/bearings.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "dataset/dense/dense_file.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/models/inverse/region_inverse.h"
#include "distortion/models/projection.h"
#include "distortion/models/warp/proved_camera.h"
#include "numbers/angles.h"

namespace cps {
namespace {

/// The derivative of a point's pixel when the point rises, as a unit vector. Its length, which depends on how
/// far away the point is, is lost; its direction is not.
Eigen::Vector2d up_at(const CalibratedCamera& camera, const Eigen::Vector3d& gravity,
                      const Eigen::Vector2d& ideal) {
  // A point P = Z (ideal, 1) that moves by −gravity moves on the plane by this, over Z.
  const Eigen::Vector2d on_plane = gravity.z() * ideal - gravity.head<2>();
  // The inverse and `gravity` have rounding errors of this size; what is left of a vertical ray is only they.
  constexpr double rounding = 1e-12;
  if (on_plane.norm() <= rounding * (1 + ideal.norm())) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d distorted = distortion_jacobian(camera.distortion, ideal) * on_plane;
  return distorted.cwiseProduct(Eigen::Vector2d(camera.pinhole.fx, camera.pinhole.fy)).normalized();
}

/// Degrees above the horizon. Not by the arcsine, which loses half of the digits near ±90°.
double latitude_deg(const Eigen::Vector3d& ray, const Eigen::Vector3d& gravity) {
  return degrees(std::atan2(-ray.dot(gravity), ray.cross(gravity).norm()));
}

void write_pixel(const CalibratedCamera& camera, const Eigen::Vector3d& gravity, DenseLabel label,
                 const Eigen::Vector2d& ideal, float* pixel) {
  const Eigen::Vector3d ray = ideal.homogeneous().normalized();
  if (label == DenseLabel::rays)
    Eigen::Vector3f::Map(pixel) = ray.cast<float>();
  else if (label == DenseLabel::up)
    Eigen::Vector2f::Map(pixel) = up_at(camera, gravity, ideal).cast<float>();
  else
    *pixel = static_cast<float>(latitude_deg(ray, gravity));
}

/// Of lenses of any family: `seen` is where the lens sends the ray.
void write_seen(const ProjectedRay& seen, const Eigen::Vector3d& ray, const Pinhole& pinhole,
                const Eigen::Vector3d& gravity, DenseLabel label, float* pixel) {
  if (label == DenseLabel::rays) {
    Eigen::Vector3f::Map(pixel) = ray.cast<float>();
  } else if (label == DenseLabel::latitude) {
    *pixel = static_cast<float>(latitude_deg(ray, gravity));
  } else {
    // A point of the ray that moves by −gravity; as in up_at(), what is left of a vertical ray is rounding.
    const Eigen::Vector2d moved = -(seen.jacobian * gravity);
    constexpr double rounding = 1e-12;
    if (moved.norm() <= rounding * seen.jacobian.norm()) return;
    Eigen::Vector2f::Map(pixel) =
        moved.cwiseProduct(Eigen::Vector2d(pinhole.fx, pinhole.fy)).normalized().cast<float>();
  }
}

template <typename Lens>
void write_rows(const Lens& lens, const RayRegion& region, const Pinhole& pinhole,
                const Eigen::Vector3d& gravity, DenseLabel label, OIIO::ImageBuf& image) {
  const RegionInverse<Lens> inverse(lens, region);
  auto* pixels = static_cast<float*>(image.localpixels());
  const int channels = image.nchannels();
  tbb::parallel_for(0, pinhole.height, [&](int y) {
    float* pixel = pixels + static_cast<std::size_t>(y) * pinhole.width * channels;
    for (int x = 0; x < pinhole.width; ++x, pixel += channels)
      if (const std::optional<Eigen::Vector3d> ray = inverse(to_plane(pinhole, {x, y})))
        write_seen(project(lens, *ray), *ray, pinhole, gravity, label, pixel);
  });
}

void require_bearing(DenseLabel label) {
  if (needs_scene(label)) throw std::runtime_error(to_string(label) + ": does not follow from the camera");
}

}  // namespace

OIIO::ImageBuf bearing_label(const CalibratedCamera& camera, const Eigen::Vector3d& gravity,
                             DenseLabel label) {
  require_bearing(label);
  const Pinhole& pinhole = camera.pinhole;
  const FrameCertificate proof = certify_frame(camera.distortion, pinhole, one_to_one);
  if (!proof.valid()) throw std::runtime_error("lens: not one-to-one on the picture: " + proof.why);

  OIIO::ImageBuf image(dense_spec(label, {pinhole.width, pinhole.height}));
  auto* pixels = static_cast<float*>(image.localpixels());
  const int channels = image.nchannels();
  tbb::parallel_for(0, pinhole.height, [&](int y) {
    float* pixel = pixels + static_cast<std::size_t>(y) * pinhole.width * channels;
    Eigen::Vector2d ideal = to_plane(pinhole, {0, y});
    for (int x = 0; x < pinhole.width; ++x, pixel += channels) {
      // Starting at the neighbour's. The certificate guarantees that an inverse exists.
      const Eigen::Vector2d distorted = to_plane(pinhole, {x, y});
      ideal = undistort_near(camera.distortion, proof.rectangle, distorted, ideal).value();
      write_pixel(camera, gravity, label, ideal, pixel);
    }
  });
  return image;
}

OIIO::ImageBuf bearing_label(const ModelCamera& camera, const Eigen::Vector3d& gravity, DenseLabel label) {
  if (const auto* lens = std::get_if<Distortion>(&camera.lens))
    return bearing_label(CalibratedCamera{camera.name, camera.pinhole, *lens}, gravity, label);
  require_bearing(label);
  const ModelCertificate proof = certify_frame(camera, one_to_one);
  if (is_empty(proof.region)) throw std::runtime_error("lens: not one-to-one on the picture: " + proof.why);
  OIIO::ImageBuf image(dense_spec(label, {camera.pinhole.width, camera.pinhole.height}));
  std::visit([&](const auto& lens) { write_rows(lens, proof.region, camera.pinhole, gravity, label, image); },
             camera.lens);
  return image;
}

}  // namespace cps
