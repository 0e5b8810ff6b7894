#pragma once

#include <OpenImageIO/imagebuf.h>

#include <functional>

#include "distortion/warp/footprints.h"
#include "distortion/warp/noise_kernels.h"
#include "distortion/warp/warp.h"

namespace cps {

/// Fills the tile's footprints for the output pixels in `rect`.
using Footprints = std::function<void(const TileRect& rect, FootprintTile& tile)>;

/// Noise to add to each pixel of the output.
struct AddedNoise {
  const OIIO::ImageBuf& image;  ///< of the source's size and number of channels, in memory
  NoiseTarget target;
};

/// Makes every pixel of `output` from its footprint in the source, which is in memory and has 1–4 channels,
/// and adds what the noise's kernels gather at the same place (Resampling::footprint only). Throws
/// std::runtime_error in one line where the options require coverage or resolution that is missing.
OIIO::ImageBuf resample(const OIIO::ImageBuf& source, const AddedNoise* noise, const Pinhole& output,
                        const WarpOptions& options, const Footprints& footprints, WarpSummary* summary);

}  // namespace cps
