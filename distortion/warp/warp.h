#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstdint>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"
#include "distortion/warp/warp_options.h"

namespace cps {

struct WarpSummary {
  double worst_residual_px = 0;         ///< of the inversion, pixels of the distorted image
  std::int64_t uncovered_pixels = 0;    ///< whose footprint leaves the source
  double smallest_kernel_sigma_px = 0;  ///< source pixels; infinite for ids and depth
};

/// The image that the lens shows at `output` of an ideal image, resampled once: each output pixel is a
/// kernel-weighted mean over its true footprint in the master (footprints.h), so that sharpness and noise do
/// not depend on the local magnification. An undistorted lens takes exactly the same path. `master` has 1–4
/// channels of any pixel type, linear, finite; the result has the same type. The same bytes for any number of
/// threads.
///
/// Throws std::runtime_error with one line: unusable options, sizes that do not match, a lens that is not
/// one-to-one on the master, footprints that leave the master, magnification above what the master carries.
OIIO::ImageBuf warp(const OIIO::ImageBuf& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options = {}, WarpSummary* summary = nullptr);

/// As warp(), and adds `noise` of the master's size through kernels of its own, as warp() of a NoisyMaster
/// does (render_noise.h), which is what to call. Without noise: warp() itself.
OIIO::ImageBuf warp_with_noise(const OIIO::ImageBuf& master, const OIIO::ImageBuf* noise,
                               const Pinhole& master_camera, const Distortion& lens, const Pinhole& output,
                               const WarpOptions& options, WarpSummary* summary = nullptr);

/// The inverse of warp(): the ideal image at `output` of `source`, which was seen through the lens at
/// `camera`. Pixels that the source does not show, or shows only beyond a fold of the lens, are 0; with
/// require_coverage they are an error. Throws as warp() does.
OIIO::ImageBuf unwarp(const OIIO::ImageBuf& source, const Pinhole& camera, const Distortion& lens,
                      const Pinhole& output, const WarpOptions& options = {}, WarpSummary* summary = nullptr);

}  // namespace cps
