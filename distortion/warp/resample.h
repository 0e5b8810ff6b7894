#pragma once

#include <OpenImageIO/imagebuf.h>

#include <functional>

#include "distortion/warp/footprints.h"
#include "distortion/warp/warp.h"

namespace cps {

/// Fills the tile's footprints for the output pixels in `rect`.
using Footprints = std::function<void(const TileRect& rect, FootprintTile& tile)>;

/// Makes every pixel of `output` from its footprint in the source, which is in memory and has 1–4 channels.
/// Throws std::runtime_error in one line where the options require coverage or resolution that is missing.
OIIO::ImageBuf resample(const OIIO::ImageBuf& source, const Pinhole& output, const WarpOptions& options,
                        const Footprints& footprints, WarpSummary* summary);

}  // namespace cps
