#pragma once

#include <OpenImageIO/imagebuf.h>

#include "distortion/warp/footprints.h"
#include "distortion/warp/warp_options.h"

namespace cps {

/// Fills one tile of the output, whose first pixel is (x0, y0), with what the rays through its pixel centres
/// meet in the source (Resampling::nearest or ::depth); 0 where they miss it. Returns how many miss it.
///
/// Depth is z along the optical axis, positive; 0 or infinite for none. On a plane 1/z is affine in the
/// image, so it is interpolated between the four surrounding pixels where they lie on one plane or smooth
/// surface, and taken from the nearest of them elsewhere.
int sample_tile(const OIIO::ImageBuf& source, const FootprintTile& tile, Resampling resampling, int x0,
                int y0, OIIO::ImageBuf& output);

}  // namespace cps
