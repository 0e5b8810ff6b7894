#include "dataset/pixels/thumbnail.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <stdexcept>

#include "dataset/pixels/image_file.h"
#include "sensor/develop.h"

namespace cps {
namespace {

OIIO::ImageBuf resized(const OIIO::ImageBuf& image, ImageSize size) {
  // Each source pixel counts in four thumbnail pixels; with the default, Lanczos' filter, it would in 36.
  // Its width is in pixels of the result: where the image is enlarged, two source pixels are more of them.
  const OIIO::ImageSpec& from = image.spec();
  const float filter_width = 2 * std::max({1.0f, static_cast<float>(size.width) / from.width,
                                           static_cast<float>(size.height) / from.height});
  return OIIO::ImageBufAlgo::resize(image, "triangle", filter_width,
                                    OIIO::ROI(0, size.width, 0, size.height, 0, 1, 0, 3));
}

/// sRGB of linear halves, by a sensor without noise.
OIIO::ImageBuf encoded(const OIIO::ImageBuf& linear) {
  return develop(linear.copy(OIIO::TypeDesc::FLOAT), 1, {.full_well_e = 1e12, .read_noise_e = 0}, Stream{});
}

}  // namespace

OIIO::ImageBuf thumbnail(const std::filesystem::path& file, ImageSize size) {
  OIIO::ImageBuf image = read_pixels(file);
  if (image.nchannels() == 1) image = OIIO::ImageBufAlgo::channels(image, 3, {0, 0, 0});
  if (image.nchannels() != 3) throw std::runtime_error(file.string() + ": has neither one channel nor three");
  const OIIO::ImageBuf small = resized(image, size);
  if (small.has_error()) throw std::runtime_error(file.string() + ": cannot be resized: " + small.geterror());
  return small.spec().format == OIIO::TypeDesc::UINT8 ? small : encoded(small);
}

std::string encode_thumbnail(OIIO::ImageBuf image, std::size_t max_bytes) {
  for (;;) {
    std::string jpeg;
    for (int quality : {82, 60, 40}) {
      jpeg = encode_image(image, ImageFormat::jpeg, quality);
      if (jpeg.size() <= max_bytes) return jpeg;
    }
    const ImageSize half = {std::max(1, image.spec().width / 2), std::max(1, image.spec().height / 2)};
    if (half.width == image.spec().width && half.height == image.spec().height) return jpeg;
    image = resized(image, half);
  }
}

}  // namespace cps
