#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstdint>
#include <filesystem>
#include <vector>

/// PNG files whose pixels are numbers of colours in a palette, as sets of class labels have them. Reading
/// them as colours would lose the numbers.
namespace cps {

/// Red, green, blue and alpha of colour 0, then of colour 1, …
using Palette = std::vector<std::uint8_t>;

/// Whether the file is a PNG with a palette.
bool is_palette_png(const std::filesystem::path& file);

/// The numbers, 8 bits, one channel; and the palette. Throws std::runtime_error naming the file.
OIIO::ImageBuf read_palette_png(const std::filesystem::path& file, Palette& palette);

/// Writes numbers and palette. Throws std::runtime_error.
void write_palette_png(const std::filesystem::path& file, const OIIO::ImageBuf& numbers,
                       const Palette& palette);

}  // namespace cps
