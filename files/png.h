#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

namespace cps {

/// The bytes of a PNG file (SUB filter, fastest deflate) that holds an 8-bit image of one or three sRGB
/// channels, or one channel of 16-bit numbers that are no colours. Written by hand because the same pixels
/// must give the same bytes whatever version of libpng is installed, and libdeflate is faster than zlib.
/// Throws std::runtime_error for other images.
std::string encode_png(const OIIO::ImageBuf& image);

}  // namespace cps
