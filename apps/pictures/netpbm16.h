#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>

/// Netpbm's binary pictures of 16 bits (.pgm, .ppm), high byte first. OpenImageIO 2.4 reads them through
/// floats, which changes values by one, and writes others.
namespace cps {

/// Whether the file is such a picture.
bool is_netpbm16(const std::filesystem::path& file);

/// The values as they are in the file, 16 bits, 1 or 3 channels. Throws std::runtime_error naming the file.
OIIO::ImageBuf read_netpbm16(const std::filesystem::path& file);

/// Writes 1 or 3 channels of any type, as 16 bits of which 65535 is white. Throws std::runtime_error.
void write_netpbm16(const std::filesystem::path& file, const OIIO::ImageBuf& pixels);

}  // namespace cps
