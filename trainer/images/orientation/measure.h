#pragma once

#include "trainer/images/gray_image.h"
#include "trainer/images/orientation/orientation.h"

namespace cps {

/// The picture in which orientation is measured: `whole`, or, if it is wider than `max_width`, an area
/// average of that width, but not smaller than the network's image.
GrayImage measured_picture(const GrayImage& whole, const ImageSize& network_image, int max_width);

/// The orientation of the edges of `picture`, pooled to orientation_grid(network_image).
///
/// Planes: the tilt of a cell is the mean over its edges, weighted by the square of their steep slope, and 0
/// where there are none. The confidence is √(w / (w + m)), where w is the sum of these squares times the
/// edges' coherence(), and m the mean over all cells of the sum of all squared gradients: 0 where nothing is
/// to be seen, .7 where a cell's edges of this family alone are as strong as all that an average cell has.
///
/// Numbers: fit_tilt() of both families. A pure function of the pixels; a few ns a pixel on one core.
Orientation orientation_of(const GrayView& picture, const ImageSize& network_image);

}  // namespace cps
