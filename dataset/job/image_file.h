#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <string>

#include "sampler/recipe/image_format.h"

/// A dataset's images as files. The same pixels give the same bytes.
namespace cps {

/// The bytes of a file: of an 8-bit image as PNG (1 or 3 channels) or JPEG (3), of three float channels as
/// EXR, which keeps them as half floats, at most 65504, without losses beyond that. Throws std::runtime_error
/// for images that do not fit.
std::string encode_image(const OIIO::ImageBuf& image, ImageFormat format, int jpeg_quality);

/// The pixels of a file of such a format: 8 bits, or halves. Throws std::runtime_error, file first.
OIIO::ImageBuf read_pixels(const std::filesystem::path& file);

/// SHA-256 of an image's pixels, rows from the top, channels interleaved, halves as two bytes, the low one
/// first: what stays the same when only the file's encoding changes.
std::string pixels_sha256(const OIIO::ImageBuf& image);

/// The same of what a reader will find in the file that holds `image`, which is not the same after losses.
std::string stored_pixels_sha256(const OIIO::ImageBuf& image, ImageFormat format, const std::string& bytes);

/// The pixels that a reader finds in the file of `image`: what JPEG or half floats leave of it, else `image`
/// itself. Throws as encode_image() does.
OIIO::ImageBuf stored_pixels(const OIIO::ImageBuf& image, ImageFormat format, int jpeg_quality);

}  // namespace cps
