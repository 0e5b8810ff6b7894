#pragma once

#include <array>
#include <span>

#include "distortion/brown_conrady.h"
#include "random/counter_hash.h"

/// A prior over the radial coefficients of photographic lenses, given the H-FOV: numbers fitted to the
/// rectilinear profiles of the Lensfun database (https://lensfun.github.io, CC BY-SA 3.0) by
/// sampler/lenses/lensfun/. In units of the half diagonal of the base's frame. See docs/lenses.md.
namespace cps {

/// Distribution of the lenses whose H-FOV lies within 5° of `hfov_deg`.
struct RealLensFit {
  double hfov_deg;
  /// Quantiles of the corner's displacement A = K1 + K2 + K3, at `corner_probabilities`.
  std::array<double, 7> corner;
  /// K2 = k2_slope · A + k2_sd · n, and K3 = k3_slope · A + k3_on_k2 · (k2_sd · n) + k3_sd · n' with n, n'
  /// standard normal.
  double k2_slope, k2_sd, k3_slope, k3_on_k2, k3_sd;
};

/// The outermost quantiles are those of 1 % and 99 %: lenses beyond them are not drawn.
inline constexpr std::array corner_probabilities = {0.0, 0.05, 0.25, 0.5, 0.75, 0.95, 1.0};

/// By ascending H-FOV.
std::span<const RealLensFit> real_lens_fits();

/// The fit at an H-FOV: linear between two fits, the outermost one beyond them.
RealLensFit real_lens_fit_at(double hfov_deg);

/// Draws the radial coefficients. They may exceed any bound; the caller rejects those that do.
Distortion draw_real_lens(double hfov_rad, Stream stream);

}  // namespace cps
