#include "distortion/models/projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps {
namespace {

using std::numbers::pi;

double limit(const Distortion&) {
  return pi / 2;
}

double limit(const RationalLens&) {
  return pi / 2;
}

double limit(const KannalaBrandt&) {
  return pi;
}

/// With c = cos θ, the radius sin θ / (c + ξ) has the slope (1 + ξ c) / (c + ξ)²: it ends where c + ξ = 0 or
/// 1 + ξ c = 0. The arc tangents here are the arc cosines, exact near π too.
double limit(const UnifiedSpherical& lens) {
  const double xi = lens.xi;
  return xi <= 1 ? std::atan2(std::sqrt((1 - xi) * (1 + xi)), -xi)
                 : std::atan2(std::sqrt((xi - 1) * (xi + 1)), -1);
}

/// With s = sin θ, c = cos θ and ρ = √(β s² + c²), the radius s / D, D = α ρ + (1 − α) c, has the slope
/// (α c/ρ + 1 − α) / D². For α < 1/2, D reaches 0 first: tan² θ = (1 − 2α) / (α² β); for α > 1/2 the slope:
/// tan² θ = (2α − 1) / ((1 − α)² β).
double limit(const Eucm& lens) {
  const double smaller = std::min(lens.alpha, 1 - lens.alpha);
  return pi - std::atan2(std::sqrt(std::abs(2 * lens.alpha - 1)), smaller * std::sqrt(lens.beta));
}

/// With w = ξ + cos θ and d = √(sin² θ + w²), the radius sin θ / D, D = α d + (1 − α) w, has the slope
/// (1 + ξ cos θ)(α w/d + 1 − α) / D². For α < 1/2, D reaches 0 first; for α > 1/2 the slope; both where
/// w = −k d with k = min(α, 1 − α) / max(α, 1 − α).
double limit(const DoubleSphere& lens) {
  const double xi = lens.xi, larger = std::max(lens.alpha, 1 - lens.alpha), k = (1 - larger) / larger;
  const double sine_on_second = std::sqrt(std::abs(2 * lens.alpha - 1)) / larger;  // √(1 − k²)
  // d is the distance of the unit sphere from the second sphere's centre: d² + 2 ξ k d = 1 − ξ².
  const double constant = (1 - xi) * (1 + xi), root = std::sqrt(constant + xi * xi * k * k);
  const double d = xi <= 0 ? root - xi * k : root > 0 ? constant / (root + xi * k) : 0;
  return std::atan2(d * sine_on_second, -k * d - xi);
}

}  // namespace

ProjectedRay project(const LensModel& lens, const Eigen::Vector3d& ray) {
  return std::visit([&](const auto& family) { return project(family, ray); }, lens);
}

double angle_limit(const LensModel& lens) {
  return std::visit([](const auto& family) { return limit(family); }, lens);
}

}  // namespace cps
