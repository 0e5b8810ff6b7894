#pragma once

#include <Eigen/Geometry>
#include <string>

#include "distortion/brown_conrady.h"

namespace cps {

/// What a lens must satisfy on its rectangle: every eigenvalue of its Jacobian (the local magnification in
/// every direction) lies in [min_eigenvalue, max_eigenvalue].
struct CertificateOptions {
  double min_eigenvalue = 0.15;
  double max_eigenvalue = 1.8;

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// Requires only that the lens does not fold.
inline constexpr CertificateOptions one_to_one{.min_eigenvalue = 1e-6, .max_eigenvalue = 1e6};

/// Proof, or refutation, that a lens maps a rectangle one-to-one. Where the symmetric Jacobian is positive
/// definite throughout a convex set the map is strictly monotone there, hence injective; the tangential terms
/// are included.
struct Certificate {
  bool valid = false;
  /// Proved: every eigenvalue lies between them. Tight to 1e-5.
  double min_eigenvalue = 0, max_eigenvalue = 0;
  /// Radius on the plane z = 1 at which the eigenvalue that breaks a limit, or comes closest to it, is
  /// attained.
  double witness_radius = 0;
  double largest_scale = 0;  ///< the largest t for which t·lens is proved valid; infinite for no distortion
  std::string why;           ///< of a refusal, one line: radius, eigenvalue, dominant term; empty when valid
};

/// The rectangle lies on the plane z = 1 of ideal points and contains the principal point (0, 0), not
/// necessarily in its middle; one that does not is widened until it does. A lens or rectangle that is not
/// finite is refused.
///
/// On a ring about the principal point the direction with the worst eigenvalue has a closed form, so the
/// search is over the radius alone: on an interval of radii, the Bernstein coefficients of the radial terms g
/// and R (polar_lens.h) bound them, and the tangential terms are bounded by their values at its ends.
Certificate certify(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                    const CertificateOptions& options = {});

/// certify(…).valid, faster because it does not compute the bounds.
bool is_certified(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                  const CertificateOptions& options = {});

}  // namespace cps
