#include "distortion/certificate/certificate.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "distortion/certificate/branch_and_bound.h"
#include "distortion/certificate/polar_lens.h"
#include "distortion/certificate/ring_eigenvalue.h"
#include "numbers/infinity.h"

namespace cps {
namespace {

/// The smallest eigenvalue over the rectangle, or minus the largest: −J has the same form as J, with the
/// signs of g and R and the direction reversed.
EnclosedMinimum extreme_eigenvalue(const PolarLens& lens, End end, const MinimumSearch& search) {
  const double sign = end == End::smallest ? 1 : -1;
  const auto smallest = [&](double g, double R, double a, Interval c) {
    return smallest_eigenvalue(g, R, a, end == End::smallest ? c : Interval{-c.high, -c.low});
  };
  const auto on_ring = [&](double r) {
    const double s = r * r, g = sign * lens.radial_slope(s), R = sign * lens.radial(s),
                 a = lens.tangential * r;
    return smallest_on_ring(lens, r, [&](Interval c) { return smallest(g, R, a, c); });
  };
  const auto on_cell = [&](double r0, double r1, double enough) {
    const double a0 = lens.tangential * r0, a1 = lens.tangential * r1;
    // Coarse bound: the worst g and the worst R of the cell, as if they occurred together. J is affine in a,
    // so its smallest eigenvalue is concave in a and therefore smallest at an end of [a0, a1].
    const Interval g = lens.radial_slope.range(r0 * r0, r1 * r1), R = lens.radial.range(r0 * r0, r1 * r1);
    const double worst_g = end == End::smallest ? g.low : -g.high,
                 worst_R = end == End::smallest ? R.low : -R.high;
    const auto coarse = [&](Interval c) {
      return std::min(smallest(worst_g, worst_R, a0, c), smallest(worst_g, worst_R, a1, c));
    };
    if (const double on_disc = coarse(every_cosine); on_disc >= enough) return on_disc;

    // Fine bound: along a ray, J is a convex combination of the matrices formed by the Bernstein coefficients
    // of g, R and a, and the smallest eigenvalue is concave. Its error falls with the square of the cell's
    // width.
    std::optional<std::array<Form<6>, 2>> forms;
    const auto fine = [&](Interval c) {
      if (!forms) forms = {lens.radial_slope.in_radius(r0, r1), lens.radial.in_radius(r0, r1)};
      const auto& [g_form, R_form] = *forms;
      double bound = infinity;
      for (int i = 0; i <= 6; ++i)
        bound = std::min(bound, smallest(sign * g_form[i], sign * R_form[i], a0 + (a1 - a0) * i / 6, c));
      return bound;
    };
    return smallest_on_ring(lens, r0, [&](Interval c) {
      const double bound = coarse(c);
      return bound >= enough ? bound : std::max(bound, fine(c));
    });
  };
  return smallest_value(0, 1, search, on_cell, on_ring);
}

bool is_finite(const Distortion& lens, const Eigen::AlignedBox2d& rectangle) {
  const std::array<double, 5> terms{lens.k1, lens.k2, lens.k3, lens.p1, lens.p2};
  return std::all_of(terms.begin(), terms.end(), [](double k) { return std::isfinite(k); }) &&
         rectangle.min().allFinite() && rectangle.max().allFinite() && (rectangle.sizes().array() > 0).all();
}

/// The term that pulls the eigenvalue at radius r furthest in the direction of `end`.
const char* dominant_term(const PolarLens& lens, double r, End end) {
  const double s = r * r, sign = end == End::smallest ? -1 : 1;
  const std::array<double, 4> pull{sign * lens.radial_slope.b * s, sign * lens.radial_slope.c * s * s,
                                   sign * lens.radial_slope.d * s * s * s, 6 * lens.tangential * r};
  constexpr std::array<const char*, 4> names{"k1", "k2", "k3", "p1, p2"};
  return names[std::max_element(pull.begin(), pull.end()) - pull.begin()];
}

std::string refusal(const PolarLens& lens, const Certificate& certificate, End end, double eigenvalue,
                    double limit) {
  return fmt::format(
      "at radius {:.4g} the {} eigenvalue of the lens' Jacobian is {:.4g}, {} {:.4g}{}; dominant term {}; "
      "the lens scaled by {:.4g} would pass",
      certificate.witness_radius, end == End::smallest ? "smallest" : "largest", eigenvalue,
      end == End::smallest ? "below" : "above", limit, eigenvalue <= 0 ? " (the image folds)" : "",
      dominant_term(lens, certificate.witness_radius / lens.unit, end), certificate.largest_scale);
}

}  // namespace

std::string CertificateOptions::fault() const {
  if (!(min_eigenvalue > 0 && min_eigenvalue < 1)) return "min_eigenvalue: must lie between 0 and 1";
  if (!(max_eigenvalue > 1 && std::isfinite(max_eigenvalue)))
    return "max_eigenvalue: must be finite and above 1";
  return "";
}

Certificate certify(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                    const CertificateOptions& options) {
  Certificate certificate;
  if (!is_finite(lens, rectangle)) {
    certificate.why = "the lens or its rectangle is empty or not finite";
    return certificate;
  }
  const PolarLens polar = polar_lens(lens, rectangle);
  const double min_allowed = options.min_eigenvalue + polar.rounding,
               max_allowed = options.max_eigenvalue - polar.rounding;
  const EnclosedMinimum smallest = extreme_eigenvalue(polar, End::smallest, {.threshold = min_allowed});
  const EnclosedMinimum largest = extreme_eigenvalue(polar, End::largest, {.threshold = -max_allowed});
  certificate.min_eigenvalue = smallest.proved - polar.rounding;
  certificate.max_eigenvalue = -largest.proved + polar.rounding;

  // The Jacobian of t·lens is I + t(J − I): its eigenvalues move along straight lines through 1.
  const auto scale_to = [](double room, double used) { return used > 0 ? room / used : infinity; };
  const double scale_down = scale_to(1 - min_allowed, 1 - smallest.proved);
  const double scale_up = scale_to(max_allowed - 1, -largest.proved - 1);
  certificate.largest_scale = std::min(scale_down, scale_up) * (1 - 1e-12);

  const bool is_smallest_nearer = scale_down <= scale_up;
  certificate.witness_radius = (is_smallest_nearer ? smallest : largest).argument * polar.unit;
  certificate.valid = smallest.proved >= min_allowed && largest.proved >= -max_allowed;
  if (!certificate.valid)
    certificate.why =
        is_smallest_nearer
            ? refusal(polar, certificate, End::smallest, smallest.attained, options.min_eigenvalue)
            : refusal(polar, certificate, End::largest, -largest.attained, options.max_eigenvalue);
  return certificate;
}

bool is_certified(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                  const CertificateOptions& options) {
  if (!is_finite(lens, rectangle)) return false;
  const PolarLens polar = polar_lens(lens, rectangle);
  const double min_allowed = options.min_eigenvalue + polar.rounding,
               max_allowed = options.max_eigenvalue - polar.rounding;
  return extreme_eigenvalue(polar, End::smallest, {infinity, min_allowed}).proved >= min_allowed &&
         extreme_eigenvalue(polar, End::largest, {infinity, -max_allowed}).proved >= -max_allowed;
}

}  // namespace cps
