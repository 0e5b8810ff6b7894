#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <string>

#include "distortion/image_size.h"

namespace cps {

/// A dataset's image made small, to look at: 8-bit sRGB of three channels, of exactly this size. Throws
/// std::runtime_error with one line, file first.
OIIO::ImageBuf thumbnail(const std::filesystem::path& file, ImageSize size);

/// The bytes of a JPEG of an 8-bit image of three channels: of as good a quality, and then size, as
/// `max_bytes` allows.
std::string encode_thumbnail(OIIO::ImageBuf image, std::size_t max_bytes);

}  // namespace cps
