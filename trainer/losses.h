#pragma once

#include <torch/types.h>

#include "trainer/targets.h"
#include "trainer/train_options.h"

namespace cps {

/// [8], 1 for the outputs that are learned and 0 for the others.
torch::Tensor output_mask(const TrainOptions& options);

/// Mean squared or Huber (δ = 1) error of the masked outputs. said and targets: [n, 8], standardised.
torch::Tensor output_loss(Loss loss, const torch::Tensor& said, const torch::Tensor& targets,
                          const torch::Tensor& mask);

/// Points of n images of one size, and where the true lens shows them.
struct RayBatch {
  torch::Tensor ideal;   ///< [n, points, 2] on the plane z = 1
  torch::Tensor pixels;  ///< [n, points, 2]
  int width = 0, height = 0;
};

/// Mean distance between where the truth and where the prediction shows the points, in hundredths of the
/// image's width: reprojection_error_px() as a differentiable function of said, [n, 8] standardised outputs
/// in `space`. A predicted H-FOV is kept between 1° and 179°, beyond which it is no camera.
torch::Tensor reprojection_loss(const torch::Tensor& said, const RayBatch& rays, TargetSpace space,
                                const Standardisation& by);

}  // namespace cps
