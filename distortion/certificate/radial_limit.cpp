#include "distortion/certificate/radial_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cps {
namespace {

/// Largest real root of u³ + a u² + b u + c, by Viète's and Cardano's formulas.
double largest_root(double a, double b, double c) {
  const double p = b - a * a / 3, q = 2 * a * a * a / 27 - a * b / 3 + c;
  const double discriminant = q * q / 4 + p * p * p / 27;
  if (discriminant > 0) {
    const double root = std::sqrt(discriminant);
    const double larger = std::cbrt(-q / 2 - std::copysign(root, q));  // no cancellation
    return larger - (larger != 0 ? p / (3 * larger) : 0) - a / 3;
  }
  const double m = 2 * std::sqrt(std::max(0.0, -p / 3));
  const double cosine = m > 0 ? std::clamp(3 * q / (p * m), -1.0, 1.0) : 1;
  return m * std::cos(std::acos(cosine) / 3) - a / 3;
}

}  // namespace

double radial_limit(const Distortion& lens) {
  // With u = 1/s the polynomial is u³ + 3 k1 u² + 5 k2 u + 7 k3. Its largest positive root gives the smallest
  // s, and its leading coefficient is never 0.
  const double a = 3 * lens.k1, b = 5 * lens.k2, c = 7 * lens.k3;
  double u = largest_root(a, b, c);
  for (int step = 0; step < 2; ++step) {
    const double slope = b + u * (2 * a + 3 * u), value = c + u * (b + u * (a + u));
    if (std::abs(value) < std::abs(slope) * std::abs(u)) u -= value / slope;
  }
  // Rounding turns a double root at 0 (k2 = k3 = 0) into a root as large as the square root of the error.
  constexpr double rounding = 1e-7;
  return u > rounding * (std::abs(a) + std::sqrt(std::abs(b)) + std::cbrt(std::abs(c)))
             ? 1 / std::sqrt(u)
             : std::numeric_limits<double>::infinity();
}

}  // namespace cps
