#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <string>

#include "apps/pictures/palette_png.h"
#include "distortion/image_size.h"
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
  /// Upright, 1 to 4 channels. For resampling by footprint: float, linear, colours multiplied by alpha; else
  /// as in the file.
  OIIO::ImageBuf pixels;
  OIIO::ImageSpec file;                     ///< pixel type, channels and metadata of the file
  Encoding encoding = Encoding::automatic;  ///< as asked for
  bool is_light = false;                    ///< resampled by footprint
  bool is_srgb = false;
  bool is_premultiplied = false;
  bool was_turned = false;  ///< as the file's EXIF orientation says
  Palette palette = {};     ///< of label ids that are numbers of colours
};

/// Size of the picture when it is shown upright, as its EXIF orientation says. Throws as read_picture() does.
ImageSize upright_size(const std::filesystem::path& file);

/// Throws std::runtime_error, one line naming the file: not a picture, damaged, several pictures in one file,
/// more than four channels, a size other than `width` × `height` once it is upright.
Picture read_picture(const std::filesystem::path& file, Encoding encoding, Resampling resampling, int width,
                     int height);

/// Writes `pixels`, made from `source`, with its encoding, pixel type and metadata, in the format that the
/// name ends with. Light goes from integers to floating point, and back, with the encoding that is usual
/// there. The file appears whole or not at all. Throws std::runtime_error naming it, too if the format cannot
/// hold the source's channels and pixel type.
void write_picture(const std::filesystem::path& file, const OIIO::ImageBuf& pixels, const Picture& source);

}  // namespace cps
