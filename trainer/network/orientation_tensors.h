#pragma once

#include <torch/types.h>

#include <span>

#include "trainer/images/batches.h"

namespace cps {

struct ModelCard;

/// The orientation of a batch's images as a network takes it. Undefined tensors for one that has none.
struct OrientationTensors {
  torch::Tensor planes;   ///< [n, 4, h', w'], see orientation_tensors(); h', w': orientation_grid()
  torch::Tensor numbers;  ///< [n, 28], OrientationNumbers, normalised

  OrientationTensors to(torch::Device device) const;
};

/// tilt · confidence of the near-vertical and of the near-horizontal edges, and the two confidences; and the
/// numbers. All are those of the flipped picture where the image says so, and are normalised by
/// card.orientation: (value − mean) / deviation. Undefined unless card.options.orientation.measured;
/// otherwise every image must have been measured, and all must have one size.
OrientationTensors orientation_tensors(std::span<const BatchImage> images, const ModelCard& card);

}  // namespace cps
