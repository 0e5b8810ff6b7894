#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "distortion/image_size.h"

namespace cps {

/// The size of the network's images. `factor` divides both sides (the published models use 4); if it is 0,
/// `width` is the width in pixels and the height keeps the aspect ratio. Images are never enlarged.
struct Reduction {
  int width = 160;
  int factor = 0;
  bool operator==(const Reduction&) const = default;
};

/// Pixels of an image of this size.
inline std::size_t pixel_count(const ImageSize& size) {
  return static_cast<std::size_t>(size.width) * size.height;
}

/// The size to which an image of size `original` is reduced, at least 1×1.
ImageSize reduced_size(const ImageSize& original, const Reduction& reduction);

/// One gray image, 8 bit, rows top to bottom without padding.
struct GrayImage {
  ImageSize size;
  std::vector<std::uint8_t> pixels;
};

/// A gray image whose pixels are owned elsewhere, in the same layout.
struct GrayView {
  ImageSize size;
  const std::uint8_t* pixels = nullptr;
};

/// The image reduced to size `to`: every output pixel is the mean of the input area that it covers, including
/// fractions of pixels. `to` must not be larger than the image.
GrayImage area_average(const GrayImage& image, const ImageSize& to);

/// Interleaved 8-bit pixels as gray: Rec. 709 luma of the first three channels, or the first of one or two.
GrayImage gray_of(const ImageSize& size, int channels, const std::uint8_t* pixels);

/// The size of an image file, of which only the header is read. Throws as read_gray_image() does.
ImageSize gray_image_size(const std::filesystem::path& file);

/// Reads any image that OpenImageIO can read, as gray (Rec. 709 luma), at full size. Luma and all averaging
/// use the encoded values, not linear light, which would spend most of the 8 bits on highlights. Throws
/// std::runtime_error with one line that starts with the file.
GrayImage read_gray_image(const std::filesystem::path& file);

}  // namespace cps
