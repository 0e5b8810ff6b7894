#include "renderer/image_error.h"

#include <cmath>
#include <stdexcept>

namespace cps {

ImageError image_error(const OIIO::ImageBuf& image, const OIIO::ImageBuf& reference) {
  const OIIO::ImageSpec &a = image.spec(), &b = reference.spec();
  constexpr int colors = 3;
  if (a.width != b.width || a.height != b.height || a.nchannels < colors || b.nchannels < colors)
    throw std::runtime_error("the reference has " + std::to_string(b.width) + " x " +
                             std::to_string(b.height) + " pixels, the picture " + std::to_string(a.width) +
                             " x " + std::to_string(a.height));
  const auto each_value = [&](const auto& use) {
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x)
        for (int c = 0; c < colors; ++c) {
          const double expected = reference.getchannel(b.x + x, b.y + y, 0, c);
          use(image.getchannel(a.x + x, a.y + y, 0, c) - expected, expected);
        }
  };
  double sum = 0, squares = 0, difference = 0, squared_difference = 0;
  each_value([&](double d, double r) {
    sum += r;
    squares += r * r;
    difference += d;
    squared_difference += d * d;
  });
  const double count = static_cast<double>(colors) * a.width * a.height, floor = 0.01 * squares / count;
  double relative = 0;
  each_value([&](double d, double r) { relative += d * d / (r * r + floor); });
  return {std::sqrt(squared_difference / count), relative / count, difference / sum};
}

}  // namespace cps
