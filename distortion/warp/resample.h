#pragma once

#include <OpenImageIO/imagebuf.h>

#include <functional>

#include "distortion/warp/footprints.h"
#include "distortion/warp/warp.h"

namespace cps {

/// Fills the tile's footprints for output pixels (x0, y0) … (x0+width−1, y0+height−1).
using Footprints = std::function<void(int x0, int y0, int width, int height, FootprintTile& tile)>;

/// Every pixel of `output` out of its footprint in the source, which is in memory and has 1–4 channels.
/// Throws std::runtime_error in one line where the options want coverage or resolution and there is none.
OIIO::ImageBuf resample(const OIIO::ImageBuf& source, const Pinhole& output, const WarpOptions& options,
                        const Footprints& footprints, WarpSummary* summary);

}  // namespace cps
