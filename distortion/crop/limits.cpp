#include "distortion/crop/limits.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <stdexcept>

#include "distortion/certificate/certificate.h"
#include "distortion/certificate/displacement.h"

namespace cps {
namespace {

double Distortion::*member(Coefficient which) {
  switch (which) {
    case Coefficient::k1:
      return &Distortion::k1;
    case Coefficient::k2:
      return &Distortion::k2;
    case Coefficient::k3:
      return &Distortion::k3;
    case Coefficient::p1:
      return &Distortion::p1;
    case Coefficient::p2:
      break;
  }
  return &Distortion::p2;
}

double half_diagonal(const Eigen::AlignedBox2d& rectangle) {
  return 0.5 * rectangle.diagonal().norm();
}

/// Distance to the nearest bound, negative outside. Concave along every straight line in the space of
/// coefficients.
double margin(const LensBounds& bounds, const Distortion& lens, const Eigen::AlignedBox2d& rectangle) {
  const Certificate proof = certify(lens, rectangle, {bounds.min_eigenvalue, bounds.max_eigenvalue});
  return std::min({proof.min_eigenvalue - bounds.min_eigenvalue, bounds.max_eigenvalue - proof.max_eigenvalue,
                   bounds.max_displacement - largest_displacement(lens, rectangle)});
}

/// The last value with `margin_at` ≥ 0 on the way from `inside`, where that holds, to `outside`.
template <typename Margin>
double last_inside(double inside, double outside, Margin margin_at) {
  const double at_inside = margin_at(inside), at_outside = margin_at(outside);
  if (at_outside >= 0) return outside;
  if (at_inside <= 0) return inside;  // on the bound, to the tightness of the proofs
  const double close_enough = 1e-9 * std::abs(outside - inside);
  const auto is_close = [&](double a, double b) { return std::abs(b - a) <= close_enough; };
  std::uintmax_t iterations = 100;
  const bool ascending = inside < outside;
  const auto [a, b] = boost::math::tools::toms748_solve(
      margin_at, ascending ? inside : outside, ascending ? outside : inside,
      ascending ? at_inside : at_outside, ascending ? at_outside : at_inside, is_close, iterations);
  const double nearer = ascending ? a : b;
  if (margin_at(nearer) < 0) return inside;
  return inside + (nearer - inside) * (1 - 1e-12);  // keeps the rounding of a drawn value inside the bounds
}

/// Bound on a coefficient's absolute value: the displacement limit (k1, k2, k3) or the cap on |(p1, p2)|
/// rules out anything larger.
double reach(const Distortion& lens, Coefficient which, const Eigen::AlignedBox2d& rectangle,
             const LensBounds& bounds) {
  const double unit = half_diagonal(rectangle), s = unit * unit;
  const Eigen::Vector2d corner =
      rectangle.min().cwiseAbs().cwiseMax(rectangle.max().cwiseAbs());  // distance from the principal point
  const double r = corner.norm(), r2 = r * r;
  // At the farthest corner |D − x| ≥ |k_i| r^(2i+1) − the other terms.
  const double others = std::abs(lens.k1) * r2 + std::abs(lens.k2) * r2 * r2 +
                        std::abs(lens.k3) * r2 * r2 * r2 + 3 * std::hypot(lens.p1, lens.p2) * r;
  const double max_term = 1.01 * (bounds.max_displacement * unit / r + others) + 1e-6;
  switch (which) {
    case Coefficient::k1:
      return max_term / r2;
    case Coefficient::k2:
      return max_term / (r2 * r2);
    case Coefficient::k3:
      return max_term / (r2 * r2 * r2);
    case Coefficient::p1:
      return std::sqrt(std::max(0.0, bounds.max_tangential * bounds.max_tangential / s - lens.p2 * lens.p2));
    case Coefficient::p2:
      return std::sqrt(std::max(0.0, bounds.max_tangential * bounds.max_tangential / s - lens.p1 * lens.p1));
  }
  return 0;
}

}  // namespace

std::string LensBounds::fault() const {
  if (std::string fault = CertificateOptions{min_eigenvalue, max_eigenvalue}.fault(); !fault.empty())
    return fault;
  if (!(max_displacement > 0 && max_displacement <= 1)) return "max_displacement: must lie between 0 and 1";
  if (!(max_tangential >= 0 && max_tangential <= 1)) return "max_tangential: must lie between 0 and 1";
  return "";
}

std::string PrincipalPointBounds::fault() const {
  if (!(max_shift_x >= 0 && max_shift_x < 0.5 && max_shift_y >= 0 && max_shift_y < 0.5))
    return "max_shift: must be at least 0 and below 0.5 of the image";
  if (!(max_zoom >= 1)) return "max_zoom: must be at least 1";
  return "";
}

double& coefficient(Distortion& lens, Coefficient which) {
  return lens.*member(which);
}
double coefficient(const Distortion& lens, Coefficient which) {
  return lens.*member(which);
}

bool is_within(const LensBounds& bounds, const Distortion& lens, const Eigen::AlignedBox2d& rectangle) {
  return is_certified(lens, rectangle, {bounds.min_eigenvalue, bounds.max_eigenvalue}) &&
         std::hypot(lens.p1, lens.p2) * half_diagonal(rectangle) <= bounds.max_tangential * (1 + 1e-12) &&
         largest_displacement(lens, rectangle) <= bounds.max_displacement;
}

Interval coefficient_limits(const Distortion& others, Coefficient which, const Eigen::AlignedBox2d& rectangle,
                            const LensBounds& bounds) {
  Distortion lens = others;
  if (!is_within(bounds, lens, rectangle)) {
    coefficient(lens, which) = 0;
    if (!is_within(bounds, lens, rectangle))
      throw std::runtime_error("coefficient limits: the other coefficients alone already break the bounds");
  }
  const double inside = coefficient(lens, which), far = reach(lens, which, rectangle, bounds);
  const auto margin_at = [&](double value) {
    coefficient(lens, which) = value;
    return margin(bounds, lens, rectangle);
  };
  return {last_inside(inside, std::min(-far, inside), margin_at),
          last_inside(inside, std::max(far, inside), margin_at)};
}

Interval principal_point_limits(const Distortion& lens, const Pinhole& base,
                                const Eigen::Vector2d& principal_point_px, PrincipalPointAxis which,
                                const PrincipalPointBounds& bounds) {
  const int axis = which == PrincipalPointAxis::cx ? 0 : 1;
  const int size = axis == 0 ? base.width : base.height;
  const double centre = 0.5 * (size - 1);
  const double reach = (axis == 0 ? bounds.max_shift_x : bounds.max_shift_y) * size;
  const auto is_allowed = [&](double value) {
    Eigen::Vector2d principal_point = principal_point_px;
    principal_point[axis] = value;
    return border_free_zoom(lens, base, principal_point) <= bounds.max_zoom;
  };
  if (!is_allowed(centre)) return {centre, centre};

  // Step outwards to the first value refused, then bisect that step.
  const auto last_allowed = [&](double direction) {
    constexpr int steps = 8;
    double inside = centre;
    for (int i = 1; i <= steps; ++i) {
      double outside = centre + direction * reach * i / steps;
      if (is_allowed(outside)) {
        inside = outside;
        continue;
      }
      while (std::abs(outside - inside) > 1e-6) {
        const double middle = 0.5 * (inside + outside);
        (is_allowed(middle) ? inside : outside) = middle;
      }
      break;
    }
    return inside;
  };
  return {last_allowed(-1), last_allowed(1)};
}

}  // namespace cps
