#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "distortion/inverse/convex_inverse.h"
#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/projection.h"

/// unproject() for many points: a RegionInverse of the lens' family is made once for a region and called for
/// each point.
namespace cps {

/// The rim of a region's cone: the ray at its largest angle, and the radius at which a radially symmetric map
/// shows it. A point beyond that radius is proved to lie outside the cone's image, because the map grows with
/// the angle; as with undistort(), one beyond it by less than 1e-12 of its size counts as inside.
struct ConeRim {
  double sine, cosine, radius;

  bool is_outside(double point_radius) const { return !(point_radius <= radius * (1 + 1e-12)); }

  /// The unit ray if it lies in the cone, otherwise the rim's ray in the direction of `point`.
  Eigen::Vector3d clamped(const Eigen::Vector3d& ray, const Eigen::Vector2d& point) const {
    if (ray.z() >= cosine) return ray;
    const double scale = sine / std::max(point.norm(), std::numeric_limits<double>::min());
    return {scale * point.x(), scale * point.y(), cosine};
  }
};

/// The unit ray below max_angle_rad whose radius in the normalised image is that of `point`. Unchecked: there
/// is one.
Eigen::Vector3d radial_ray(const KannalaBrandt& lens, double max_angle_rad, const Eigen::Vector2d& point);

inline Eigen::Vector3d radial_ray(const Eucm& lens, double, const Eigen::Vector2d& point) {
  // The ray (x, y, z) with denominator 1: α √(β r² + z²) + (1 − α) z = 1. Both forms of z are its larger
  // root.
  const double alpha = lens.alpha, r2 = point.squaredNorm(), excess = 2 * alpha - 1;
  const double root = alpha * std::sqrt(std::max(0.0, 1 - excess * lens.beta * r2));
  const double z = alpha > 0.75 ? (root - (1 - alpha)) / excess
                                : (1 - alpha * alpha * lens.beta * r2) / (root + (1 - alpha));
  return Eigen::Vector3d(point.x(), point.y(), z) / std::sqrt(r2 + z * z);
}

/// The unit ray that a sphere shows in direction (x, y, z) from the point (0, 0, −ξ).
inline Eigen::Vector3d ray_from_centre(double xi, double x, double y, double z) {
  const double across2 = x * x + y * y, length2 = across2 + z * z, along = xi * z;
  const double constant = (1 - xi) * (1 + xi);
  const double root = std::sqrt(std::max(0.0, z * z + constant * across2));
  // (along + root) / length2, without cancellation
  const double scale = along >= 0 ? (along + root) / length2 : constant / (root - along);
  return {scale * x, scale * y, scale * z - xi};
}

inline Eigen::Vector3d radial_ray(const DoubleSphere& lens, double, const Eigen::Vector2d& point) {
  // The second sphere is an EUCM with β = 1, which gives the direction from the first one's centre.
  const Eigen::Vector3d direction = radial_ray(Eucm{.alpha = lens.alpha, .beta = 1}, 0, point);
  return ray_from_centre(lens.xi, direction.x(), direction.y(), direction.z());
}

/// Radially symmetric families.
template <typename Lens>
class RegionInverse {
 public:
  RegionInverse(const Lens& lens, const RayRegion& region) : lens_(lens), angle_(region.max_angle_rad) {
    const auto [sine, cosine] = straight_sine_cosine(angle_);
    rim_ = {sine, cosine, project(lens, Eigen::Vector3d(sine, 0, cosine)).point.x()};
  }

  /// unproject() of unproject.h.
  std::optional<Eigen::Vector3d> operator()(const Eigen::Vector2d& point) const {
    if (rim_.is_outside(point.norm())) return {};
    return rim_.clamped(radial_ray(lens_, angle_, point), point);
  }

 private:
  Lens lens_;
  double angle_;
  ConeRim rim_;
};

/// A lens on the plane of (x, y) / (z + ξ), inside a rectangle and a cone; the plane z = 1 has ξ = 0. A
/// region without a rectangle is the cone alone.
template <typename Lens>
class PlaneRegionInverse {
 public:
  PlaneRegionInverse(const Lens& lens, double xi, const RayRegion& region) : lens_(lens), xi_(xi) {
    const auto [sine, cosine] = straight_sine_cosine(region.max_angle_rad);
    const double along = cosine + xi;
    rim_ = {sine, cosine, along > 0 ? sine / along : std::numeric_limits<double>::infinity()};
    const Eigen::Vector2d corner = Eigen::Vector2d::Constant(rim_.radius);
    box_ = region.box.value_or(Eigen::AlignedBox2d(-corner, corner));
  }

  /// unproject() of unproject.h.
  std::optional<Eigen::Vector3d> operator()(const Eigen::Vector2d& point) const {
    const std::optional<Eigen::Vector2d> ideal = convex_inverse(lens_, box_, point);
    if (!ideal || rim_.is_outside(ideal->norm())) return {};
    return rim_.clamped(ray_from_centre(xi_, ideal->x(), ideal->y(), 1), *ideal);
  }

 private:
  Lens lens_;
  double xi_;
  ConeRim rim_;
  Eigen::AlignedBox2d box_;
};

template <>
class RegionInverse<Distortion> : public PlaneRegionInverse<Distortion> {
 public:
  RegionInverse(const Distortion& lens, const RayRegion& region) : PlaneRegionInverse(lens, 0, region) {}
};

template <>
class RegionInverse<RationalLens> : public PlaneRegionInverse<RationalLens> {
 public:
  RegionInverse(const RationalLens& lens, const RayRegion& region) : PlaneRegionInverse(lens, 0, region) {}
};

template <>
class RegionInverse<UnifiedSpherical> : public PlaneRegionInverse<Distortion> {
 public:
  RegionInverse(const UnifiedSpherical& lens, const RayRegion& region)
      : PlaneRegionInverse(lens.distortion, lens.xi, region) {}
};

}  // namespace cps
