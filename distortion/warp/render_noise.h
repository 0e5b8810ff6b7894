#pragma once

#include "distortion/warp/warp.h"

namespace cps {

/// A master that was rendered twice, each time with half of its samples and with random numbers of its own:
/// the mean of both halves, and half their difference, which is noise like the mean's and nothing else.
struct NoisyMaster {
  OIIO::ImageBuf picture, noise;
};

/// Throws std::runtime_error when the halves differ in size, channels or pixel type.
NoisyMaster join_halves(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second);

/// Side of the master pixels, output pixels, that render noise looks as if it came from: enlarged by 1.6,
/// with the default oversampling. Most drawn pixels are enlarged less (docs/lens.md).
inline constexpr double noise_grain_px = 0.8;

/// As warp() of the picture, but with the same render noise everywhere. Where a lens enlarges, fewer master
/// pixels meet in an output pixel, so level and grain of the noise would map the lens. Some of master.noise
/// is added, weighted and through a kernel of its own, so that both become those of a master with pixels of
/// noise_grain_px. What the picture shows is not touched: what is added has mean 0. Where master pixels are
/// larger than that, noise stays as it is. docs/lens.md has the derivation.
///
/// Throws as warp() does, and when the master is to be sampled rather than filtered.
OIIO::ImageBuf warp(const NoisyMaster& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options = {}, WarpSummary* summary = nullptr);

}  // namespace cps
