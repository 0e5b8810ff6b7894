#pragma once

#include "distortion/warp/warp.h"

namespace cps {

/// A master rendered as two halves, each with half of the samples and its own random numbers. `picture` is
/// the mean of the halves; `noise` is half their difference: it shows nothing of the scene and has the
/// statistics of the noise in `picture`.
struct NoisyMaster {
  OIIO::ImageBuf picture, noise;
};

/// Throws std::runtime_error when the halves differ in size, channels or pixel type.
NoisyMaster join_halves(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second);

/// The warp makes render noise look as if it came from master pixels of this side, in output pixels. It is
/// the side of a master pixel that the lens enlarges by 1.6, at the default oversampling; most pixels of
/// drawn lenses are enlarged less (docs/lens.md).
inline constexpr double noise_grain_px = 0.8;

/// As warp() of the picture, but with the same render noise everywhere. Where a lens enlarges, fewer master
/// pixels contribute to an output pixel, so level and grain of the noise would reveal the lens. The warp adds
/// master.noise, weighted and through a separate kernel, so that both are those of a master with pixels of
/// noise_grain_px. The added noise has mean 0 and leaves the scene as it is. Where master pixels are larger
/// than noise_grain_px, nothing is added. docs/lens.md has the derivation.
///
/// Throws as warp() does, and if options.resampling is not Resampling::footprint.
OIIO::ImageBuf warp(const NoisyMaster& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options = {}, WarpSummary* summary = nullptr);

}  // namespace cps
