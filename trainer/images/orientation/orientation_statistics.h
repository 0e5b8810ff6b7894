#pragma once

#include <array>
#include <span>

#include "trainer/images/orientation/orientation.h"

namespace cps {

/// Mean and standard deviation, over a training set, of what a network gets of the orientation.
struct OrientationStatistics {
  /// Of tilt · confidence of near-vertical and of near-horizontal edges, then of the two confidences.
  std::array<double, orientation_plane_count> plane_mean{}, plane_deviation{};
  std::array<double, orientation_number_count> number_mean{}, number_deviation{};
};

/// Over all cells of all images, and over the images' numbers. There must be at least one image, and all must
/// be measured. A deviation below 1e-6 becomes 1.
OrientationStatistics orientation_statistics(std::span<const OrientationView> images);

}  // namespace cps
