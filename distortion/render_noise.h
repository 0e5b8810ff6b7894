#pragma once

#include "distortion/warp.h"

namespace cps {

/// A master rendered twice, each time with half of its samples and with random numbers of its own: the mean
/// is the picture, half the difference another sample of its noise.
struct MasterHalves {
  OIIO::ImageBuf first, second;
};
OIIO::ImageBuf mean(const MasterHalves& halves);

/// Side of the master pixels, output pixels, that render noise looks as if it came from: enlarged by 1.6,
/// with the default oversampling. Nine drawn pixels of ten or more are enlarged less (docs/lens.md).
inline constexpr double noise_grain_px = 0.8;

/// As warp() of the halves' mean, but with the same render noise everywhere. Where a lens enlarges, fewer
/// master pixels meet in an output pixel, so the level and the grain of noise would map the lens. Half the
/// difference of the halves is added, through a narrower kernel and weighted, so that level and grain become
/// those of a master with pixels of noise_grain_px. What the picture shows is not touched: the difference has
/// mean 0. Where master pixels are larger than that, noise stays as it is.
///
/// Noise of independent pixels and variance v has, in the output, spectral density v·a·exp(−ω²(σ² − a/12)), a
/// the output's area under a master pixel. To reach the same with g² in place of a, to second order in ω, the
/// difference is weighted by √(g²/a − 1) and gathered with σ² − g²/12.
///
/// Throws as warp() does, and when the halves differ in size, channels or pixel type, or when they are to be
/// sampled rather than filtered.
OIIO::ImageBuf warp(const MasterHalves& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options = {}, WarpSummary* summary = nullptr);

}  // namespace cps
