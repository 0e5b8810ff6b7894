#include "distortion/models/certificate/sphere_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "distortion/certificate/branch_and_bound.h"
#include "distortion/certificate/rim_search.h"
#include "distortion/models/certificate/radial_certificate.h"
#include "distortion/models/straight_angle.h"

namespace cps {
namespace {

/// The angle on a circle of `radius` at which it crosses a side at `distance` from its centre, from the
/// direction of that side; 0 if it does not.
double crossing(double distance, double radius) {
  return radius > distance
             ? angle_from_axis(std::sqrt((radius - distance) * (radius + distance)), distance).angle_rad
             : 0;
}

}  // namespace

SphereReach sphere_reach(double xi) {
  // Divided by 1 + ξ the denominator is that of eucm with β = 1.
  const double angle = largest_growing_angle(Eucm{.alpha = xi / (1 + xi), .beta = 1});
  const auto [sine, cosine] = straight_sine_cosine(angle);
  return {angle, sine / (cosine + xi)};
}

double angle_on_sphere(double xi, double radius) {
  const double square = radius * radius;
  const double scale = (xi + std::sqrt(std::max(0.0, 1 + (1 - xi) * (1 + xi) * square))) / (1 + square);
  return angle_from_axis(scale * radius, scale - xi).angle_rad;
}

bool keeps_circle_out(const Distortion& lens, const Eigen::AlignedBox2d& box, double radius,
                      const Eigen::AlignedBox2d& frame) {
  // On the circle the image is R r e + r² (2 (q·e) e + q) with a unit vector e and q = (p2, p1): the second
  // derivative of each coordinate by the angle is at most |R| r + 4 |q| r².
  const double square = radius * radius;
  const double factor = 1 + square * (lens.k1 + square * (lens.k2 + square * lens.k3));
  const double bend = std::abs(factor) * radius + 4 * Eigen::Vector2d(lens.p2, lens.p1).norm() * square;
  constexpr double rounding = 1e-11;
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const bool is_left = quadrant & 1, is_above = quadrant & 2;
    const double x = is_left ? -box.min().x() : box.max().x(), y = is_above ? -box.min().y() : box.max().y();
    const double first = crossing(x, radius), last = std::numbers::pi / 2 - crossing(y, radius);
    if (first > last) continue;
    const auto image = [&](double angle) {
      const auto [sine, cosine] = straight_sine_cosine(angle);
      return distort(lens, radius * Eigen::Vector2d(is_left ? -cosine : cosine, is_above ? -sine : sine));
    };
    const auto value = [&](double angle) { return gauge(frame, image(angle)) - rounding; };
    const auto bound = [&](double low, double high, double) {
      const Eigen::Vector2d from = image(low), to = image(high);
      const double sag = bend * (high - low) * (high - low) / 8;
      const Eigen::Vector2d least = from.cwiseMin(to), most = from.cwiseMax(to);
      return smallest_gauge(frame, {least.x() - sag, most.x() + sag}, {least.y() - sag, most.y() + sag}) -
             rounding;
    };
    const MinimumSearch verdict{std::numeric_limits<double>::infinity(), 1};
    if (!(smallest_value(first, last, verdict, bound, value).proved >= 1)) return false;
  }
  return true;
}

}  // namespace cps
