#include "distortion/models/certificate/rational_certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "distortion/certificate/bernstein.h"
#include "distortion/certificate/branch_and_bound.h"
#include "distortion/certificate/grow_rectangle.h"
#include "distortion/certificate/polar_lens.h"
#include "distortion/certificate/ring_eigenvalue.h"
#include "numbers/infinity.h"

namespace cps {
namespace {

/// A rational lens on a rectangle, scaled as a PolarLens is.
struct PolarRational {
  PolarLens tangential;  ///< quadrants, unit and tangential terms; no radial ones
  std::array<double, 3> n, d;
};

PolarRational polar_rational(const RationalLens& lens, const Eigen::AlignedBox2d& rectangle) {
  const PolarLens tangential = polar_lens({.p1 = lens.p1, .p2 = lens.p2}, rectangle);
  const Distortion n = rescaled(Distortion{lens.k1, lens.k2, lens.k3}, tangential.unit),
                   d = rescaled(Distortion{lens.k4, lens.k5, lens.k6}, tangential.unit);
  return {tangential, {n.k1, n.k2, n.k3}, {d.k1, d.k2, d.k3}};
}

/// 1 + k1 s + k2 s² + k3 s³ for s from s[0] to s[1].
Form<3> cubic(const std::array<double, 3>& k, const Form<1>& s) {
  return sum(sum(sum(binomials<3>, k[0], s * binomials<2>), k[1], s * s * binomials<1>), k[2], s * s * s);
}

/// k1 + 2 k2 s + 3 k3 s².
Form<2> slope(const std::array<double, 3>& k, const Form<1>& s) {
  return sum(sum(sum(Form<2>{}, k[0], binomials<2>), 2 * k[1], s * binomials<1>), 3 * k[2], s * s);
}

/// 1 + Σ |k_i| s^i: bounds the polynomial's terms, and with a few unit roundoffs its rounding error.
double size(const std::array<double, 3>& k, double s) {
  return 1 + s * (std::abs(k[0]) + s * (std::abs(k[1]) + s * std::abs(k[2])));
}

/// g and R at seven points whose convex hull contains them for all s of an interval.
struct RadialHull {
  std::array<double, 7> g, R;
  double rounding = infinity;  ///< on any of them; infinite if D is not proved positive
};

RadialHull radial_hull(const PolarRational& lens, double s0, double s1) {
  const Form<1> s{s0, s1};
  const Form<3> N = cubic(lens.n, s), D = cubic(lens.d, s);
  double least = infinity;
  for (int i = 0; i <= 3; ++i) least = std::min(least, D[i] / binomials<3>[i]);
  const double n_size = size(lens.n, s1), d_size = size(lens.d, s1);
  constexpr double roundings = 64 * 0x1p-53;
  RadialHull hull;
  if (!(least > roundings * d_size)) return hull;

  const Form<6> ND = N * D, squared = D * D;
  const Form<6> G = sum(ND, 2, s * sum(slope(lens.n, s) * D, -1, N * slope(lens.d, s)));
  double largest = 0;
  for (int i = 0; i <= 6; ++i) {
    hull.g[i] = G[i] / squared[i];
    hull.R[i] = ND[i] / squared[i];
    largest = std::max({largest, std::abs(hull.g[i]), std::abs(hull.R[i])});
  }
  const double relative = d_size / least;
  const double margin =
      roundings * (13 * n_size / least * relative + 2 * largest * relative) + lens.tangential.rounding;
  if (std::isfinite(margin)) hull.rounding = margin;
  return hull;
}

/// As extreme_eigenvalue() of certificate.cpp; the rounding error is taken off the bounds.
EnclosedMinimum extreme_eigenvalue(const PolarRational& lens, End end, const MinimumSearch& search) {
  const double sign = end == End::smallest ? 1 : -1;
  const auto smallest = [&](const RadialHull& hull, int i, double a, Interval c) {
    return smallest_eigenvalue(sign * hull.g[i], sign * hull.R[i], a,
                               end == End::smallest ? c : Interval{-c.high, -c.low});
  };
  const auto on_ring = [&](double r) {
    const RadialHull hull = radial_hull(lens, r * r, r * r);
    if (hull.rounding == infinity) return -infinity;
    return smallest_on_ring(lens.tangential, r,
                            [&](Interval c) { return smallest(hull, 0, lens.tangential.tangential * r, c); });
  };
  const auto on_cell = [&](double r0, double r1, double) {
    const RadialHull hull = radial_hull(lens, r0 * r0, r1 * r1);
    if (hull.rounding == infinity) return -infinity;
    const double a0 = lens.tangential.tangential * r0, a1 = lens.tangential.tangential * r1;
    return smallest_on_ring(lens.tangential, r0, [&](Interval c) {
      double bound = infinity;
      for (int i = 0; i <= 6; ++i)
        bound = std::min({bound, smallest(hull, i, a0, c), smallest(hull, i, a1, c)});
      return bound - hull.rounding;
    });
  };
  return smallest_value(0, 1, search, on_cell, on_ring);
}

bool is_finite(const RationalLens& lens, const Eigen::AlignedBox2d& rectangle) {
  const std::array<double, 8> terms{lens.k1, lens.k2, lens.k3, lens.k4, lens.k5, lens.k6, lens.p1, lens.p2};
  return std::all_of(terms.begin(), terms.end(), [](double k) { return std::isfinite(k); }) &&
         rectangle.min().allFinite() && rectangle.max().allFinite() && (rectangle.sizes().array() > 0).all();
}

bool is_denominator_positive(const PolarRational& lens, double r) {
  const auto value = [&](double s) { return radial_hull(lens, s, s).rounding < infinity ? 1.0 : -1.0; };
  const auto bound = [&](double s0, double s1, double) {
    return radial_hull(lens, s0, s1).rounding < infinity ? 1.0 : -1.0;
  };
  return smallest_value(0, r * r, {infinity, 0.5}, bound, value).proved > 0;
}

/// The radius up to which the denominator is proved positive, in units of the rectangle's.
double pole(const PolarRational& lens) {
  double positive = 0, refused = 1;
  while (refused - positive > 1e-9) {
    const double middle = 0.5 * (positive + refused);
    (is_denominator_positive(lens, middle) ? positive : refused) = middle;
  }
  return positive;
}

std::string refusal(double radius, const char* which, double eigenvalue, const char* side, double limit) {
  return fmt::format("at radius {:.4g} the {} eigenvalue of the lens' Jacobian is {:.4g}, {} {:.4g}{}",
                     radius, which, eigenvalue, side, limit, eigenvalue <= 0 ? " (the image folds)" : "");
}

}  // namespace

Certificate certify(const RationalLens& lens, const Eigen::AlignedBox2d& rectangle,
                    const CertificateOptions& options) {
  Certificate certificate;
  if (!is_finite(lens, rectangle)) {
    certificate.why = "the lens or its rectangle is empty or not finite";
    return certificate;
  }
  const PolarRational polar = polar_rational(lens, rectangle);
  if (!is_denominator_positive(polar, 1)) {
    certificate.witness_radius = pole(polar) * polar.tangential.unit;
    certificate.why = fmt::format("at radius {:.4g} the denominator 1 + k4 r² + k5 r⁴ + k6 r⁶ falls to zero",
                                  certificate.witness_radius);
    return certificate;
  }
  const EnclosedMinimum smallest =
      extreme_eigenvalue(polar, End::smallest, {.threshold = options.min_eigenvalue});
  const EnclosedMinimum largest =
      extreme_eigenvalue(polar, End::largest, {.threshold = -options.max_eigenvalue});
  certificate.min_eigenvalue = smallest.proved;
  certificate.max_eigenvalue = -largest.proved;
  const bool is_large_enough = smallest.proved >= options.min_eigenvalue,
             is_small_enough = largest.proved >= -options.max_eigenvalue;
  certificate.valid = is_large_enough && is_small_enough;
  const bool is_smallest_worse = !is_large_enough || is_small_enough;
  certificate.witness_radius = (is_smallest_worse ? smallest : largest).argument * polar.tangential.unit;
  if (!is_large_enough)
    certificate.why =
        refusal(certificate.witness_radius, "smallest", smallest.attained, "below", options.min_eigenvalue);
  else if (!is_small_enough)
    certificate.why =
        refusal(certificate.witness_radius, "largest", -largest.attained, "above", options.max_eigenvalue);
  return certificate;
}

bool is_certified(const RationalLens& lens, const Eigen::AlignedBox2d& rectangle,
                  const CertificateOptions& options) {
  if (!is_finite(lens, rectangle)) return false;
  const PolarRational polar = polar_rational(lens, rectangle);
  return extreme_eigenvalue(polar, End::smallest, {infinity, options.min_eigenvalue}).proved >=
             options.min_eigenvalue &&
         extreme_eigenvalue(polar, End::largest, {infinity, -options.max_eigenvalue}).proved >=
             -options.max_eigenvalue;
}

FrameCertificate certify_frame(const RationalLens& lens, const Pinhole& camera,
                               const CertificateOptions& options) {
  return certify_grown_rectangle(lens, camera, frame_on_plane(camera), options);
}

}  // namespace cps
