#pragma once

#include <filesystem>
#include <vector>

#include "renderer/aov.h"

namespace cps {

/// Writes one EXR, losslessly compressed. The first layer's channels keep their names (R, G, B), the others'
/// are called layer.channel. Every channel keeps its type. Throws std::runtime_error that names the file.
void write_exr(const std::filesystem::path& file, const std::vector<ImageLayer>& layers);

/// Writes a PNG in 8-bit sRGB at this exposure, without sensor noise.
void write_png(const std::filesystem::path& file, const OIIO::ImageBuf& linear, double exposure,
               std::uint64_t seed);

}  // namespace cps
