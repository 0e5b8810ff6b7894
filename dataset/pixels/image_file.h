#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <string>

#include "sampler/recipe/image_format.h"

/// A dataset's image files. The same pixels give the same bytes.
namespace cps {

/// The bytes of an image file: PNG for 8 bits and 1 or 3 channels, JPEG for 8 bits and 3 channels, EXR for
/// three float channels, which it stores losslessly as half floats clamped to [0, 65504]. Throws
/// std::runtime_error for an image that the format cannot hold.
std::string encode_image(const OIIO::ImageBuf& image, ImageFormat format, int jpeg_quality);

/// The pixels of such a file: 8 bits, or half floats. Throws std::runtime_error with one line, file first.
OIIO::ImageBuf read_pixels(const std::filesystem::path& file);

/// SHA-256 of an image's pixels: rows from the top, channels interleaved, half floats as two bytes with the
/// low one first. It stays the same when only the file's encoding changes.
std::string pixels_sha256(const OIIO::ImageBuf& image);

/// The same hash of the pixels that a reader decodes from `bytes`, the file that holds `image`. They differ
/// from `image` in lossy formats.
std::string stored_pixels_sha256(const OIIO::ImageBuf& image, ImageFormat format, const std::string& bytes);

/// The pixels that a reader finds in the file of `image`: what JPEG or half floats leave of it, else `image`
/// itself. Throws as encode_image() does.
OIIO::ImageBuf stored_pixels(const OIIO::ImageBuf& image, ImageFormat format, int jpeg_quality);

}  // namespace cps
