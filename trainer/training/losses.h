#pragma once

#include <torch/types.h>

#include "trainer/calibration/targets.h"
#include "trainer/model/train_options.h"

namespace cps {

/// [8], 1 for the outputs that are learned and 0 for the others.
torch::Tensor output_mask(const TrainOptions& options);

/// Mean squared or Huber (δ = 1) error of the outputs that are learned, by output_mask(). said and truth: [n,
/// 8], standardised. Computed where `said` is.
torch::Tensor output_loss(Loss loss, const torch::Tensor& said, const torch::Tensor& truth,
                          const torch::Tensor& learned);

/// Points of n images of one size, and where the true lens shows them.
struct RayBatch {
  torch::Tensor ideal;   ///< [n, points, 2] on the plane z = 1
  torch::Tensor pixels;  ///< [n, points, 2]
  int width = 0, height = 0;
};

/// Mean distance between where the truth and where the prediction shows the points, in hundredths of the
/// image's width: reprojection_error_px() as a differentiable function of said, [n, 8] standardised outputs
/// in `space`, computed where said is. A predicted H-FOV is kept between 1° and 179°, beyond which it is no
/// camera.
torch::Tensor reprojection_loss(const torch::Tensor& said, const RayBatch& rays, TargetSpace space,
                                const Standardisation& by);

}  // namespace cps
