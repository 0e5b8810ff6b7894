#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

namespace cps {

/// An 8-bit image as the bytes of a PNG file (fast deflate, UP filter). The same pixels give the same bytes.
std::string encode_png(const OIIO::ImageBuf& image);

/// SHA-256 of an 8-bit image's pixels, rows from the top, channels interleaved: what stays the same when only
/// the file's encoding changes.
std::string pixels_sha256(const OIIO::ImageBuf& image);

}  // namespace cps
