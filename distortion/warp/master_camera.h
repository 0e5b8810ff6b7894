#pragma once

#include "distortion/pinhole.h"
#include "distortion/warp/warp_options.h"

/// The master: the ideal image, larger and finer than the output, that the warp reads.
namespace cps {

/// Margin that a master needs on each side, master pixels, so that every footprint of a border-free crop lies
/// inside it: support · sigma · oversampling / min_eigenvalue, rounded up. `min_eigenvalue` > 0 is the lens'
/// smallest.
int master_pad(const WarpOptions& options, double min_eigenvalue);

/// The camera that renders the master for `base`: oversampled and padded.
Pinhole master_camera(const Pinhole& base, const WarpOptions& options, double min_eigenvalue);

/// Largest zoom · eigenvalue up to which a master is fine enough for the kernel: the value for
/// CropOptions::max_magnification.
double largest_magnification(const WarpOptions& options);

}  // namespace cps
