#pragma once

#include <functional>

#include "distortion/calibrated_camera.h"
#include "trainer/images/gray_image.h"

namespace cps {

/// A picture whose pixels are the mean of `brightness` over 2×2 points each. Coordinates are in pixels from
/// the picture's centre, x to the right and y down.
GrayImage drawn(const ImageSize& size, const std::function<double(double x, double y)>& brightness);

/// Vertical bars with a sine profile, 12 pixels apart, that move right by `slope` pixels for each one down.
GrayImage leaning_bars(const ImageSize& size, double slope);

/// The same turned by a right angle: horizontal bars that move down by `slope` for each pixel to the right.
GrayImage sloping_bars(const ImageSize& size, double slope);

/// A frontal wall with a grid of thin dark lines, some 20 pixels apart, seen through the camera.
GrayImage wall_grid(const CalibratedCamera& camera);

/// Left and right exchanged.
GrayImage flipped(const GrayImage& image);

/// The image without its owner; `image` must outlive it.
inline GrayView view_of(const GrayImage& image) {
  return {image.size, image.pixels.data()};
}

}  // namespace cps
