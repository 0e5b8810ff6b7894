#include "trainer/images/network_image.h"

#include "trainer/images/orientation/measure.h"

namespace cps {

NetworkImage network_image(const GrayImage& whole, const Reduction& reduction,
                           const OrientationOptions& orientation) {
  NetworkImage image{.gray = area_average(whole, reduced_size(whole.size, reduction))};
  if (orientation.measured) {
    const GrayImage measured = measured_picture(whole, image.gray.size, orientation.max_width);
    image.orientation = orientation_of({measured.size, measured.pixels.data()}, image.gray.size);
  }
  return image;
}

NetworkImage network_image_of_measured(const GrayImage& measured, const ImageSize& original,
                                       const Reduction& reduction) {
  NetworkImage image{.gray = area_average(measured, reduced_size(original, reduction))};
  image.orientation = orientation_of({measured.size, measured.pixels.data()}, image.gray.size);
  return image;
}

BatchImage batch_image(const NetworkImage& image, const ImageSize& original, bool mirror) {
  return {{image.gray.size, image.gray.pixels.data()}, original, mirror, view_of(image.orientation)};
}

}  // namespace cps
