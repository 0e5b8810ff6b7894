#pragma once

#include "distortion/warp/footprints.h"

namespace cps {

/// The warp makes render noise look as if it came from master pixels of this side, in output pixels. It is
/// the side of a master pixel that the lens enlarges by 1.6, at the default oversampling; most pixels of
/// drawn lenses are enlarged less (docs/lens.md).
inline constexpr double noise_grain_px = 0.8;

/// The noise that master pixels of noise_grain_px would leave behind a kernel of standard deviation sigma_px.
struct NoiseTarget {
  double sigma2;       ///< sigma_px²
  double level;        ///< variance, as a multiple of that of an output pixel's worth of master pixels
  double correlation;  ///< of neighbouring pixels

  explicit NoiseTarget(double sigma_px);
};

/// Kernels, and a factor on what each of them gathers.
struct WeightedKernelRow {
  KernelRow kernels;
  alignas(32) std::array<float, KernelRow::side> weight;
};

/// The kernels through which a row of `count` pixels takes noise to add. The noise that is in the picture
/// already, behind the kernels `picture`, and the noise added then have the target's correlation of
/// neighbours along both principal axes of each footprint, and the target's level (docs/lens.md has the
/// derivation). Every ellipse lies inside the picture's. The weight is 0 where the picture has enough noise.
void make_noise_kernels(const NoiseTarget& target, const KernelRow& picture, int count,
                        WeightedKernelRow& noise);

}  // namespace cps
