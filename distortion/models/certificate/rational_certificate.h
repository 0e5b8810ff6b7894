#pragma once

#include <Eigen/Geometry>

#include "distortion/certificate/certificate.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/models/rational.h"
#include "distortion/pinhole.h"

/// The certificate of certificate/ for the rational family. Its map is the gradient of a function too: the
/// Jacobian is symmetric, and in the radial/tangential frame it is [[g + 6ac, 2a√(1−c²)], [·, R + 2ac]] as
/// for Brown–Conrady (polar_lens.h), with R = N/D and g = R + 2 s R' quotients of polynomials in s = r².
namespace cps {

/// certify() for a rational lens. D is proved to be positive on the rectangle. A quotient of polynomials with
/// a denominator whose Bernstein coefficients are positive is a convex combination of the quotients of
/// coefficients, so the smallest eigenvalue, which is concave, is smallest at one of those. Certificate's
/// largest_scale is not computed: a rational lens is not scaled by its coefficients.
Certificate certify(const RationalLens& lens, const Eigen::AlignedBox2d& rectangle,
                    const CertificateOptions& options = {});

/// certify(…).valid, faster.
bool is_certified(const RationalLens& lens, const Eigen::AlignedBox2d& rectangle,
                  const CertificateOptions& options = {});

/// smallest_rim_gauge() for a rational lens; −∞ where D is not proved positive on the rim.
double smallest_rim_gauge(const RationalLens& lens, const Eigen::AlignedBox2d& rectangle,
                          const Eigen::AlignedBox2d& frame);

/// certify_frame() for a rational lens.
FrameCertificate certify_frame(const RationalLens& lens, const Pinhole& camera,
                               const CertificateOptions& options = {});

}  // namespace cps
