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
  bool is_valid(std::string* why) const;
};

/// Asks nothing of a lens but that it does not fold.
inline constexpr CertificateOptions one_to_one{.min_eigenvalue = 1e-6, .max_eigenvalue = 1e6};

/// Proof, or refutation, that a lens maps a rectangle one-to-one. Where the symmetric Jacobian is positive
/// definite throughout a convex set the map is strictly monotone there, hence injective; the tangential terms
/// are included.
struct Certificate {
  bool valid = false;
  double min_eigenvalue = 0,
         max_eigenvalue = 0;  ///< proved: every eigenvalue lies between them (tight to 1e-5)
  double witness_radius =
      0;  ///< on the plane z = 1: where the eigenvalue nearest to refusal, or refused, is attained
  double largest_scale = 0;  ///< the largest t for which t·lens is proved valid; infinite for no distortion
  std::string why;           ///< of a refusal, one line: radius, eigenvalue, dominant term; empty when valid
};

/// The rectangle lies on the plane z = 1 of ideal points and contains the principal point (0, 0), not
/// necessarily in its middle; one that does not is widened until it does. A lens or rectangle that is not
/// finite is refused.
///
/// On a ring about the principal point the eigenvalues have a closed-form worst direction, so the search is
/// over the radius alone: g and R are bounded on a cell of radii by their Bernstein coefficients, the
/// tangential terms at its ends.
Certificate certify(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                    const CertificateOptions& options = {});

/// certify(…).valid without the bounds: for samplers.
bool is_certified(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                  const CertificateOptions& options = {});

}  // namespace cps
