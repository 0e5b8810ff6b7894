#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

namespace cps {

/// An 8-bit image of one or three sRGB channels as the bytes of a PNG file (SUB filter, fast deflate). The
/// same pixels give the same bytes. Throws std::runtime_error for other images.
std::string encode_png(const OIIO::ImageBuf& image);

}  // namespace cps
