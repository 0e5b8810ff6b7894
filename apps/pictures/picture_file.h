#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <string>

#include "distortion/warp/warp.h"

/// Reading pictures of any program and camera for filtering, and writing them back in the same form.
namespace cps {

/// What the pixel values of a file are.
enum class Encoding {
  automatic,  ///< integers: sRGB, unless the file says that it is linear; half and float: linear light
  srgb,
  linear,  ///< linear light, or data: normals, masks, ids, depth
};
/// `auto`, `srgb`, `linear`. Throws std::runtime_error, naming these, on any other word.
Encoding encoding_from_string(const std::string& word);

struct Picture {
  /// 1 to 4 channels. For resampling by footprint: float, linear, colours multiplied by alpha; else as in the
  /// file.
  OIIO::ImageBuf pixels;
  OIIO::ImageSpec file;  ///< pixel type, channels and metadata of the file
  bool is_srgb = false;
};

/// The header of a picture: its size, channels and pixel type. Throws as read_picture() does.
OIIO::ImageSpec read_picture_header(const std::filesystem::path& file);

/// Throws std::runtime_error, one line naming the file: not a picture, damaged, several pictures in one file,
/// more than four channels, a size other than `width` × `height`.
Picture read_picture(const std::filesystem::path& file, Encoding encoding, Resampling resampling, int width,
                     int height);

/// Writes `pixels`, made from `source`, with its encoding, pixel type and metadata, in the format that the
/// name ends with. The file appears whole or not at all. Throws std::runtime_error naming it.
void write_picture(const std::filesystem::path& file, const OIIO::ImageBuf& pixels, const Picture& source);

}  // namespace cps
