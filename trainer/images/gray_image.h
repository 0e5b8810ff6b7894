#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "distortion/image_size.h"

namespace cps {

/// How large an image the network sees. `factor` divides both sides (the published models use 4); where it is
/// 0, `width` is the network image's width and the height follows. Images are never enlarged.
struct Reduction {
  int width = 160;
  int factor = 0;
  bool operator==(const Reduction&) const = default;
};

/// Pixels of an image of this size.
inline std::size_t pixel_count(const ImageSize& size) {
  return static_cast<std::size_t>(size.width) * size.height;
}

ImageSize reduced_size(const ImageSize& original, const Reduction& reduction);

/// One gray image, 8 bit, rows top to bottom without padding.
struct GrayImage {
  ImageSize size;
  std::vector<std::uint8_t> pixels;
};

/// Its pixels somewhere else.
struct GrayView {
  ImageSize size;
  const std::uint8_t* pixels = nullptr;
};

/// Every output pixel is the mean of the input area it covers, fractions of pixels included. `to` must not be
/// larger than the image.
GrayImage area_average(const GrayImage& image, const ImageSize& to);

/// Interleaved 8-bit pixels as gray: Rec. 709 luma of the first three channels, or the first of one or two.
GrayImage gray_of(const ImageSize& size, int channels, const std::uint8_t* pixels);

/// Any image OpenImageIO can read, as gray (Rec. 709 luma), before reduction. Luma and all averaging work on
/// the encoded values, as the picture's viewers and most networks see them: linear light would spend 8 bits
/// on highlights. Throws std::runtime_error with one line that starts with the file.
GrayImage read_gray_image(const std::filesystem::path& file);

}  // namespace cps
