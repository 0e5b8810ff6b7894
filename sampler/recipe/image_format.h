#pragma once

#include <array>
#include <stdexcept>
#include <string>

#include "sensor/sensor.h"

namespace cps {

/// What a dataset's images are kept as.
enum class ImageFormat {
  png,       ///< 8-bit sRGB
  png_gray,  ///< 8 bits of a sensor without colours
  jpeg,      ///< 8-bit sRGB, with losses
  exr        ///< linear half floats before noise, clipping and 8 bits
};

inline constexpr std::array<const char*, 4> image_format_names = {"png", "png_gray", "jpeg", "exr"};

inline std::string to_string(ImageFormat format) {
  return image_format_names[static_cast<std::size_t>(format)];
}

/// Throws std::runtime_error naming the formats there are.
inline ImageFormat image_format_from(const std::string& name) {
  for (std::size_t i = 0; i < image_format_names.size(); ++i)
    if (name == image_format_names[i]) return static_cast<ImageFormat>(i);
  throw std::runtime_error("must be png, png_gray, jpeg or exr");
}

/// What photograph() must deliver for images of this format.
inline PixelFormat pixel_format_of(ImageFormat format) {
  if (format == ImageFormat::exr) return PixelFormat::linear;
  return format == ImageFormat::png_gray ? PixelFormat::gray : PixelFormat::rgb;
}

/// `png`, `jpg` or `exr`.
inline std::string extension_of(ImageFormat format) {
  if (format == ImageFormat::jpeg) return "jpg";
  return format == ImageFormat::exr ? "exr" : "png";
}

}  // namespace cps
