#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "distortion/brown_conrady.h"
#include "distortion/certificate/bernstein.h"
#include "numbers/interval.h"

namespace cps {

/// 1 + b s + c s² + d s³ with s = r².
struct RadialCubic {
  double b, c, d;
  double operator()(double s) const { return 1 + s * (b + s * (c + s * d)); }

  /// Encloses the values on [s0, s1] by the Bernstein coefficients in s.
  Interval range(double s0, double s1) const {
    const auto slope = [&](double s) { return b + s * (2 * c + s * 3 * d); };
    const double third = (s1 - s0) / 3;
    const double b0 = (*this)(s0), b3 = (*this)(s1);
    const double b1 = b0 + third * slope(s0), b2 = b3 - third * slope(s1);
    return {std::min(std::min(b0, b1), std::min(b2, b3)), std::max(std::max(b0, b1), std::max(b2, b3))};
  }

  /// The Bernstein coefficients in r on [r0, r1].
  Form<6> in_radius(double r0, double r1) const {
    const Form<2> s = Form<1>{r0, r1} * Form<1>{r0, r1};
    const Form<4> s2 = s * s;
    Form<6> form = sum(sum(sum(binomials<6>, b, s * binomials<4>), c, s2 * binomials<2>), d, s2 * s);
    for (int i = 0; i <= 6; ++i) form[i] /= binomials<6>[i];
    return form;
  }
};

/// A lens on a rectangle, in polar coordinates about the principal point. Lengths are scaled so that the
/// rectangle's farthest corner lies at radius 1. At x = r·e, with q = (p2, p1), a = |q| r and c the cosine of
/// the angle between q and x, the Jacobian in the radial/tangential frame is
/// [[g + 6ac, 2a√(1−c²)], [2a√(1−c²), R + 2ac]]: on a ring of radius r it depends on the direction only
/// through c.
struct PolarLens {
  /// The part of the rectangle in one quadrant, reflected into x, y ≥ 0.
  struct Quadrant {
    double x = 0, y = 0;         ///< far corner
    double corner_radius = 0;    ///< 0: the rectangle has no part in this quadrant
    Eigen::Vector2d pull{1, 0};  ///< unit vector along the reflected q
  };

  RadialCubic radial;        ///< R(s) = 1 + k1 s + k2 s² + k3 s³
  RadialCubic radial_slope;  ///< g(s) = d(rR)/dr = 1 + 3 k1 s + 5 k2 s² + 7 k3 s³
  double tangential = 0;     ///< |q|
  double unit = 1;           ///< the farthest corner's radius on the plane z = 1
  double rounding = 0;       ///< bound on the rounding error of anything computed from the Jacobian
  std::array<Quadrant, 4> quadrants;
};

/// The rectangle is widened to contain the principal point (0, 0) where it does not.
PolarLens polar_lens(const Distortion& lens, const Eigen::AlignedBox2d& rectangle);

/// The range of c (see PolarLens) in a quadrant of the rectangle at radius r. Where the ring leaves the
/// rectangle its arc shrinks as r grows, so the range at r contains the ranges at all larger radii.
inline Interval cosines(const PolarLens::Quadrant& quadrant, double r) {
  Eigen::Vector2d first(1, 0), last(0, 1);  // of the arc, counter-clockwise
  if (r > quadrant.x) {
    const double c = quadrant.x / r;
    first = {c, std::sqrt(std::max(0.0, 1 - c * c))};
  }
  if (r > quadrant.y) {
    const double s = quadrant.y / r;
    last = {std::sqrt(std::max(0.0, 1 - s * s)), s};
  }
  const Eigen::Vector2d& q = quadrant.pull;
  const auto cross = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  const double before = cross(first, q), after = cross(q, last);
  const double from_first = first.dot(q), from_last = last.dot(q);
  const bool along = before >= 0 && after >= 0 && from_first + from_last > 0;
  const bool against = before <= 0 && after <= 0 && from_first + from_last < 0;
  return {against ? -1.0 : std::min(from_first, from_last), along ? 1.0 : std::max(from_first, from_last)};
}

/// Smallest value over the part of the ring at radius r that lies in the rectangle. `by_cosines` returns the
/// smallest value over a range of cosines.
template <typename ByCosines>
double smallest_on_ring(const PolarLens& lens, double r, ByCosines by_cosines) {
  constexpr double corner_rounding = 1 - 1e-12;
  double smallest = std::numeric_limits<double>::infinity();
  for (const PolarLens::Quadrant& quadrant : lens.quadrants)
    if (quadrant.corner_radius > 0 && r * corner_rounding <= quadrant.corner_radius)
      smallest = std::min(smallest, by_cosines(cosines(quadrant, r)));
  return smallest;
}

}  // namespace cps
