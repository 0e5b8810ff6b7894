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

/// As warp() of the picture, but with the same render noise everywhere. Where a lens enlarges, fewer master
/// pixels contribute to an output pixel, so level and grain of the noise would reveal the lens. The warp adds
/// master.noise, weighted and through a separate kernel, so that both are those of a master with pixels of
/// noise_grain_px (noise_kernels.h). The added noise has mean 0 and leaves the scene as it is. Where master
/// pixels are larger than noise_grain_px, nothing is added. docs/lens.md has the derivation.
///
/// Throws as warp() does, if picture and noise differ in size or channels, and if options.resampling is not
/// Resampling::footprint.
OIIO::ImageBuf warp(const NoisyMaster& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options = {}, WarpSummary* summary = nullptr);

}  // namespace cps
