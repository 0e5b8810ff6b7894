#include "distortion/models/certificate/radial_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "distortion/certificate/bernstein.h"
#include "distortion/certificate/branch_and_bound.h"
#include "distortion/models/projection.h"
#include "distortion/models/straight_angle.h"
#include "numbers/infinity.h"

namespace cps {
namespace {

constexpr Interval everything{-infinity, infinity};
constexpr double rounding = 0x1p-46;

/// Encloses (α u + 1 − α) / (α + (1 − α) u)², the derivative of sin ψ / (α + (1 − α) cos ψ) by ψ, for cosines
/// u = cos ψ in [low, high]. It grows with u up to (α² − 2(1 − α)²) / (α (1 − α)) and falls from there.
Interval sphere_slopes(double alpha, double low, double high) {
  struct Fraction {
    double numerator, root;
  };
  const auto at = [&](double u) -> Fraction { return {alpha * u + (1 - alpha), alpha + (1 - alpha) * u}; };
  const auto below = [](const Fraction& f) {
    const double least = f.numerator - rounding, root = f.root + std::copysign(rounding, least);
    return least / (root * root);
  };
  const auto above = [](const Fraction& f) {
    const double most = f.numerator + rounding, root = f.root - std::copysign(rounding, most);
    return most / (root * root);
  };
  const Fraction first = at(low), last = at(high);
  if (!(first.root > 2 * rounding && last.root > 2 * rounding)) return everything;
  Interval slopes{std::min(below(first), below(last)), std::max(above(first), above(last))};
  const double stationary = (alpha * alpha - 2 * (1 - alpha) * (1 - alpha)) / (alpha * (1 - alpha));
  if (low < stationary && stationary < high) slopes.high = std::max(slopes.high, above(at(stationary)));
  return slopes;
}

/// The products of a positive factor and a slope.
Interval product(Interval positive, Interval slope) {
  const double least = positive.low * (1 - rounding), most = positive.high * (1 + rounding);
  if (slope.low == -infinity || !(least > 0 && most < infinity)) return everything;
  return {slope.low * (slope.low < 0 ? most : least), slope.high * (slope.high < 0 ? least : most)};
}

template <typename Lens>
EnclosedMinimum smallest_slope(const Lens& lens, double max_angle_rad, const MinimumSearch& search) {
  return smallest_value(
      0, max_angle_rad, search,
      [&](double low, double high, double) { return radial_slopes(lens, low, high).low; },
      [&](double angle) { return radial_slopes(lens, angle, angle).high; });
}

template <typename Lens>
double largest_proved_angle(const Lens& lens) {
  const auto grows_to = [&](double angle) {
    return smallest_slope(lens, angle, {infinity, least_radial_slope}).proved >= least_radial_slope;
  };
  double proved = 0, refused = angle_limit(LensModel(lens)) - 1e-9;
  if (grows_to(refused)) return refused;
  while (refused - proved > 1e-12) {
    const double middle = 0.5 * (proved + refused);
    (grows_to(middle) ? proved : refused) = middle;
  }
  return proved;
}

/// The bounds of products of two factors converge only as fast as the intervals shrink.
constexpr int max_halvings = 1 << 16;

template <typename Lens>
RadialCertificate slopes_in_cone(const Lens& lens, double max_angle_rad) {
  const EnclosedMinimum smallest =
      smallest_slope(lens, max_angle_rad, {.threshold = least_radial_slope, .max_halvings = max_halvings});
  const EnclosedMinimum largest = smallest_value(
      0, max_angle_rad, {.max_halvings = max_halvings},
      [&](double low, double high, double) { return -radial_slopes(lens, low, high).high; },
      [&](double angle) { return -radial_slopes(lens, angle, angle).low; });
  return {{smallest.proved, -largest.proved}, smallest.argument};
}

}  // namespace

Interval radial_slopes(const KannalaBrandt& lens, double low_rad, double high_rad) {
  const std::array<double, 4> k{3 * lens.k1, 5 * lens.k2, 7 * lens.k3, 9 * lens.k4};
  const Form<1> s{low_rad * low_rad, high_rad * high_rad};
  const Form<2> s2 = s * s;
  const Form<4> form = sum(sum(sum(sum(binomials<4>, k[0], s * binomials<3>), k[1], s2 * binomials<2>), k[2],
                               s2 * s * binomials<1>),
                           k[3], s2 * s2);
  double size = 1, power = 1;
  for (int i = 0; i < 4; ++i) size += std::abs(k[i]) * (power *= s[1]);
  const double margin = rounding * size;
  if (!std::isfinite(margin)) return everything;
  Interval slopes{infinity, -infinity};
  for (int i = 0; i <= 4; ++i) {
    const double coefficient = form[i] / binomials<4>[i];
    slopes = {std::min(slopes.low, coefficient), std::max(slopes.high, coefficient)};
  }
  return {slopes.low - margin, slopes.high + margin};
}

Interval radial_slopes(const Eucm& lens, double low_rad, double high_rad) {
  // tan ψ = √β tan θ, dψ/dθ = √β / ρ² with ρ² = β sin²θ + cos²θ, cos ψ = cos θ / ρ, and r = … / √β.
  const auto [sine0, cosine0] = straight_sine_cosine(low_rad);
  const auto [sine1, cosine1] = straight_sine_cosine(high_rad);
  const double square0 = lens.beta * sine0 * sine0 + cosine0 * cosine0,
               square1 = lens.beta * sine1 * sine1 + cosine1 * cosine1;
  double least = std::min(square0, square1), most = std::max(square0, square1);
  constexpr double right_angle = std::numbers::pi / 2;
  if (low_rad < right_angle && right_angle < high_rad)
    least = std::min(least, lens.beta), most = std::max(most, lens.beta);
  return product({1 / most, 1 / least},
                 sphere_slopes(lens.alpha, cosine1 / std::sqrt(square1), cosine0 / std::sqrt(square0)));
}

Interval radial_slopes(const DoubleSphere& lens, double low_rad, double high_rad) {
  // ψ is the angle seen from the second sphere's centre: with d² = 1 + 2 ξ cos θ + ξ², cos ψ = (ξ + cos θ) /
  // d and dψ/dθ = (1 + ξ cos θ) / d², which is monotone in cos θ. With the squares of sin θ/2 and cos θ/2
  // every sum but that of cos ψ has positive terms only.
  struct Angle {
    double cosine, slope;
  };
  const double more = 1 + lens.xi, less = 1 - lens.xi;
  const auto at = [&](double angle_rad) -> Angle {
    const auto [sine, cosine] = straight_sine_cosine(0.5 * angle_rad);
    const double ahead = cosine * cosine, behind = sine * sine;
    const double square = more * more * ahead + less * less * behind;
    return {(more * ahead - less * behind) / std::sqrt(square), (more * ahead + less * behind) / square};
  };
  const Angle first = at(low_rad), last = at(high_rad);
  return product({std::min(first.slope, last.slope), std::max(first.slope, last.slope)},
                 sphere_slopes(lens.alpha, last.cosine, first.cosine));
}

double largest_growing_angle(const KannalaBrandt& lens) {
  return largest_proved_angle(lens);
}
double largest_growing_angle(const Eucm& lens) {
  return largest_proved_angle(lens);
}
double largest_growing_angle(const DoubleSphere& lens) {
  return largest_proved_angle(lens);
}

RadialCertificate certify_cone(const KannalaBrandt& lens, double max_angle_rad) {
  return slopes_in_cone(lens, max_angle_rad);
}
RadialCertificate certify_cone(const Eucm& lens, double max_angle_rad) {
  return slopes_in_cone(lens, max_angle_rad);
}
RadialCertificate certify_cone(const DoubleSphere& lens, double max_angle_rad) {
  return slopes_in_cone(lens, max_angle_rad);
}

}  // namespace cps
