#pragma once

#include "distortion/models/double_sphere.h"
#include "distortion/models/eucm.h"
#include "distortion/models/kannala_brandt.h"
#include "numbers/interval.h"

/// Proofs for radially symmetric lenses: they are one-to-one on a cone of rays about the axis where the
/// radius r in the normalised image grows with the angle θ from the axis.
namespace cps {

/// A lens counts as growing only where dr/dθ is at least this, so that its inverse is well conditioned.
inline constexpr double least_radial_slope = 1e-6;

/// Encloses dr/dθ for θ in [low_rad, high_rad] ⊂ [0, π], rounding included; from −∞ to ∞ where the formula is
/// not proved to be defined.
///
/// kannala_brandt: Bernstein bounds of the slope, a polynomial of degree 4 in θ². eucm and double_sphere:
/// r ∝ sin ψ / (α + (1 − α) cos ψ) with an angle ψ that grows with θ, so dr/dθ = dψ/dθ · dr/dψ; both factors
/// are monotone or have one stationary point, in closed form. Their numbers are of size 1, and 2⁻⁴⁶ on each
/// covers the roundings.
Interval radial_slopes(const KannalaBrandt& lens, double low_rad, double high_rad);
Interval radial_slopes(const Eucm& lens, double low_rad, double high_rad);
Interval radial_slopes(const DoubleSphere& lens, double low_rad, double high_rad);

/// The largest angle, to 1e-12, up to which dr/dθ ≥ least_radial_slope is proved; at most angle_limit() less
/// 1e-9. The lens' parameters are in range (not checked).
double largest_growing_angle(const KannalaBrandt& lens);
double largest_growing_angle(const Eucm& lens);
double largest_growing_angle(const DoubleSphere& lens);

/// What is proved about dr/dθ on [0, θmax].
struct RadialCertificate {
  Interval slope;                ///< encloses dr/dθ, tight to 1e-5 where it is of size 1
  double witness_angle_rad = 0;  ///< where the smallest slope is attained
};
RadialCertificate certify_cone(const KannalaBrandt& lens, double max_angle_rad);
RadialCertificate certify_cone(const Eucm& lens, double max_angle_rad);
RadialCertificate certify_cone(const DoubleSphere& lens, double max_angle_rad);

}  // namespace cps
