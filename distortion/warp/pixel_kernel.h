#pragma once

#include <cmath>

namespace cps {

/// The warp's kernel, k(d) = (1 − d·C⁻¹d / support²)³ inside the ellipse where that is positive: a piecewise
/// cubic in the squared distance that looks like a Gaussian, has covariance C exactly when support² = 10,
/// ends smoothly instead of being cut off, and costs four multiplications.
inline constexpr double kernel_support = 3.1622776601683795;  // √10 standard deviations

/// Narrowest kernel, source pixels. Below it a footprint holds so few samples that the image ripples with the
/// phase between the two pixel grids: by .002 px at .44, .06 px at .38 (docs/benchmarks/lens.md).
inline constexpr double narrowest_sigma_px = 0.42;

/// Variance of a square pixel of side 1 along either of its sides.
inline constexpr double pixel_variance = 1.0 / 12;

/// A = ∂source px/∂output px at one output pixel.
struct PixelJacobian {
  double xx, xy, yx, yy;
};

/// The kernel of one output pixel, source pixels.
struct PixelKernel {
  double conic_xx, conic_xy, conic_yy;  ///< C⁻¹ / support²
  double half_width, half_height;       ///< of the ellipse's bounding box
  double smaller_variance;  ///< smaller eigenvalue of C before it is raised to narrowest_sigma_px²
};

/// The kernel with C = variance · A Aᵀ − diag(own_xx, own_yy), where `own` is the variance of a source pixel,
/// since the source's pixels are already averages over their areas. Where the smaller eigenvalue is below
/// narrowest_sigma_px², both are raised by what it lacks. Without branches or calls, and always inlined, so
/// that a loop over it compiles to vector instructions.
[[gnu::always_inline]] inline PixelKernel pixel_kernel(const PixelJacobian& a, double variance, double own_xx,
                                                       double own_yy) {
  constexpr double support2 = kernel_support * kernel_support;
  constexpr double narrowest = narrowest_sigma_px * narrowest_sigma_px;
  double cxx = variance * (a.xx * a.xx + a.xy * a.xy) - own_xx;
  double cyy = variance * (a.yx * a.yx + a.yy * a.yy) - own_yy;
  const double cxy = variance * (a.xx * a.yx + a.xy * a.yy);
  const double half_difference = 0.5 * (cxx - cyy);
  const double smaller = 0.5 * (cxx + cyy) - std::sqrt(half_difference * half_difference + cxy * cxy);
  const double lacking = narrowest - smaller > 0 ? narrowest - smaller : 0;
  cxx += lacking;
  cyy += lacking;
  const double to_conic = 1 / ((cxx * cyy - cxy * cxy) * support2);
  return {.conic_xx = cyy * to_conic,
          .conic_xy = -cxy * to_conic,
          .conic_yy = cxx * to_conic,
          .half_width = kernel_support * std::sqrt(cxx),
          .half_height = kernel_support * std::sqrt(cyy),
          .smaller_variance = smaller};
}

}  // namespace cps
