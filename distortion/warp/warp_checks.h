#pragma once

#include <OpenImageIO/imagebuf.h>

#include "distortion/pinhole.h"
#include "distortion/warp/warp.h"

/// What every resampling requires, refused by std::runtime_error in one line.
namespace cps {

/// Throws for unusable options, a source whose pixels are not in memory, that has not the size of its camera
/// or not 1 to 4 channels, and an output without a positive size and positive focal lengths.
void check_source(const OIIO::ImageBuf& source, const Pinhole& camera, const Pinhole& output,
                  const WarpOptions& options);

/// Throws where the options require coverage or resolution that the finished warp lacks.
void check_summary(const WarpSummary& summary, const WarpOptions& options);

}  // namespace cps
