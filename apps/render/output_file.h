#pragma once

#include <filesystem>
#include <vector>

#include "renderer/aov.h"

namespace cps {

/// One EXR, losslessly compressed: the first layer's channels under their own names (R, G, B), the others' as
/// layer.channel. Every channel keeps its type.
void write_exr(const std::filesystem::path& file, const std::vector<ImageLayer>& layers);

/// 8-bit sRGB at this exposure, without a sensor's noise.
void write_png(const std::filesystem::path& file, const OIIO::ImageBuf& linear, double exposure,
               std::uint64_t seed);

}  // namespace cps
