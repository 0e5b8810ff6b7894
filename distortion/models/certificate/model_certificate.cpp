#include "distortion/models/certificate/model_certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/models/certificate/rational_certificate.h"
#include "distortion/models/certificate/rays_of_proof.h"
#include "distortion/models/projection.h"
#include "distortion/models/straight_angle.h"
#include "numbers/angles.h"

namespace cps {
namespace {

ModelCertificate refused(const std::string& why) {
  ModelCertificate result;
  result.why = why;
  return result;
}

/// Empty, or what makes a camera unusable, as certify_frame() says it for Brown–Conrady.
std::string fault(const Pinhole& camera) {
  if (camera.width <= 0 || camera.height <= 0) return "width, height: must be positive";
  if (!(camera.fx > 0 && camera.fy > 0 && std::isfinite(camera.fx) && std::isfinite(camera.fy)))
    return "fx, fy: must be positive and finite";
  const Eigen::AlignedBox2d frame = frame_on_plane(camera);
  if (!((frame.min().array() < 0).all() && (frame.max().array() > 0).all()))
    return "cx, cy: the principal point lies outside the image";
  return "";
}

/// How far from the axis the frame of a unified camera reaches on the sphere's plane.
double farthest_corner(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                       const Eigen::AlignedBox2d& frame) {
  double farthest = 0;
  for (const auto type : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                          Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight})
    if (const auto ideal = undistort(lens, rectangle, frame.corner(type)))
      farthest = std::max(farthest, ideal->norm());
  return farthest;
}

struct OnFrame {
  const Pinhole& camera;
  const CertificateOptions& options;

  template <typename Lens>
  ModelCertificate of_plane(const Lens& lens) const {
    const FrameCertificate proof = certify_frame(lens, camera, options);
    if (proof.rectangle.isEmpty()) return refused(proof.why);
    ModelCertificate result = on_plane(proof.certificate, proof.rectangle);
    result.valid = proof.valid();
    result.why = proof.why;
    return result;
  }
  ModelCertificate operator()(const Distortion& lens) const { return of_plane(lens); }
  ModelCertificate operator()(const RationalLens& lens) const { return of_plane(lens); }

  ModelCertificate operator()(const UnifiedSpherical& lens) const {
    const FrameCertificate proof = certify_frame(lens.distortion, camera, options);
    const SphereReach reach = sphere_reach(lens.xi);
    ModelCertificate result = on_sphere(lens.xi, reach, proof.certificate, proof.rectangle);
    result.valid = proof.valid();
    result.why = proof.why;
    const Eigen::AlignedBox2d frame = frame_on_plane(camera);
    if (!result.valid || farthest_radius(proof.rectangle) <= reach.max_radius ||
        keeps_circle_out(lens.distortion, proof.rectangle, reach.max_radius, frame))
      return result;
    result.valid = false;
    result.why = fmt::format(
        "the frame reaches to radius {:.4g} on the sphere's plane (x, y) / (z + ξ); for ξ = {:.4g} rays land "
        "within {:.4g}, at up to {:.5g}° off the axis",
        farthest_corner(lens.distortion, proof.rectangle, frame), lens.xi, reach.max_radius,
        degrees(reach.max_angle_rad));
    return result;
  }

  template <typename Lens>
  ModelCertificate operator()(const Lens& lens) const {
    const auto radius_at = [&](double angle_rad) {
      const auto [sine, cosine] = straight_sine_cosine(angle_rad);
      return project(lens, {sine, 0, cosine}).point.x();
    };
    const Eigen::AlignedBox2d frame = frame_on_plane(camera);
    const double growing = largest_growing_angle(lens), reached = radius_at(growing);
    const double corner = farthest_radius(frame) * (1 + 1e-12);
    if (!(reached >= corner)) {
      ModelCertificate result = on_cone(lens, growing);
      const Eigen::Vector2d far = frame.min().cwiseAbs().cwiseMax(frame.max());
      const double corner_px = far.cwiseProduct(Eigen::Vector2d(camera.fx, camera.fy)).norm();
      result.valid = false;
      result.why = fmt::format(
          "the frame's corner, {:.1f} px from the principal point, lies beyond the image of the lens: the "
          "radius grows only up to {:.5g}° off the axis, {:.1f} px in that direction",
          corner_px, degrees(growing), corner_px * reached / corner);
      return result;
    }
    double inside = 0, outside = growing;
    while (outside - inside > 1e-12) {
      const double middle = 0.5 * (inside + outside);
      (radius_at(middle) >= corner ? outside : inside) = middle;
    }
    return on_cone(lens, outside);
  }
};

}  // namespace

ModelCertificate certify_frame(const ModelCamera& camera, const CertificateOptions& options) {
  if (!std::holds_alternative<Distortion>(camera.lens)) {
    if (const std::string why = fault(camera.lens); !why.empty()) return refused(why);
    if (const std::string why = fault(camera.pinhole); !why.empty()) return refused(why);
  }
  return std::visit(OnFrame{camera.pinhole, options}, camera.lens);
}

}  // namespace cps
