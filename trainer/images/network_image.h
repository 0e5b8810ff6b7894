#pragma once

#include "trainer/images/batches.h"
#include "trainer/images/gray_image.h"
#include "trainer/images/orientation/orientation.h"

namespace cps {

/// All that a network gets of a picture, apart from its size.
struct NetworkImage {
  GrayImage gray;             ///< reduced
  Orientation orientation{};  ///< of the picture before reduction; empty: not measured
};

/// The network's image of a picture at its original size. Orientation is measured in measured_picture().
NetworkImage network_image(const GrayImage& whole, const Reduction& reduction,
                           const OrientationOptions& orientation);

/// The same of the picture after changes that are made to measured_picture(): also the gray image is reduced
/// from `measured`. `original` is the size before any reduction.
NetworkImage network_image_of_measured(const GrayImage& measured, const ImageSize& original,
                                       const Reduction& reduction);

/// The image as a member of a batch. It points into `image`.
BatchImage batch_image(const NetworkImage& image, const ImageSize& original, bool mirror = false);

}  // namespace cps
