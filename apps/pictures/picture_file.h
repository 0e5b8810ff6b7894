#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <string>

#include "distortion/warp/warp.h"

/// Pictures of any program and camera, read so that they may be filtered, and written as they were.
namespace cps {

/// What the numbers of a file stand for.
enum class Encoding {
  automatic,  ///< integers: sRGB, unless the file says that it is linear; half and float: linear light
  srgb,
  linear,  ///< linear light, or data: normals, masks, ids, depth
};
/// Throws std::runtime_error naming the words there are.
Encoding encoding_from_string(const std::string& word);

struct Picture {
  /// 1–4 channels. For ids and depth as in the file; else float, linear, colours multiplied by alpha.
  OIIO::ImageBuf pixels;
  OIIO::ImageSpec file;  ///< pixel type, channels and metadata of the file
  bool is_srgb = false;
};

/// Size of a picture in pixels, from its header. Throws like read_picture.
OIIO::ImageSpec read_picture_header(const std::filesystem::path& file);

/// Throws std::runtime_error, one line naming the file: not a picture, damaged, several pictures in one file,
/// more than four channels, a size other than `width` × `height`.
Picture read_picture(const std::filesystem::path& file, Encoding encoding, Resampling resampling, int width,
                     int height);

/// Writes `pixels`, made from `source`, with its encoding, pixel type and metadata, in the format that the
/// name ends with. The file appears whole or not at all. Throws std::runtime_error naming it.
void write_picture(const std::filesystem::path& file, const OIIO::ImageBuf& pixels, const Picture& source);

}  // namespace cps
