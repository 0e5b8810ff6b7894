#pragma once

#include <OpenImageIO/imagebuf.h>

#include "distortion/models/model_camera.h"
#include "distortion/warp/warp.h"

namespace cps {

/// The picture that `output` would have taken of what `source` took from the same place, resampled once: each
/// output pixel is a kernel-weighted mean over its footprint in the source (footprints.h), for any two lens
/// families. Pixels that the source does not show are 0; with WarpOptions::require_coverage they are an
/// error. `options.box` is not used. Both lenses must be one-to-one on their frames, or are used where they
/// are proved. Throws std::runtime_error as warp() does.
OIIO::ImageBuf warp_between(const OIIO::ImageBuf& source, const ModelCamera& source_camera,
                            const ModelCamera& output, const WarpOptions& options = {},
                            WarpSummary* summary = nullptr);

/// Which pixels of `output` warp_between() makes from a whole footprint inside the source's frame, or, with
/// another resampling, from a point inside it: 255, or 0.
/// One channel of 8 bits. Throws as warp_between() does for unusable options and lenses.
OIIO::ImageBuf valid_pixels(const ModelCamera& source_camera, const ModelCamera& output,
                            const WarpOptions& options = {});

}  // namespace cps
