#pragma once

#include <torch/types.h>

#include "trainer/calibration/targets.h"
#include "trainer/model/train_options.h"

namespace cps {

/// The learned outputs as a mask: [8], 1 for those that are learned and 0 for the others.
torch::Tensor output_mask(const TrainOptions& options);

/// Mean squared or Huber (δ = 1) error over the learned outputs, by output_mask(). predicted and truth: [n,
/// 8], standardised. Computed on the device of `predicted`.
torch::Tensor output_loss(Loss loss, const torch::Tensor& predicted, const torch::Tensor& truth,
                          const torch::Tensor& learned);

/// Ideal points for n images of one size, and the pixels where the true lens images them.
struct RayBatch {
  torch::Tensor ideal;   ///< [n, points, 2] on the plane z = 1
  torch::Tensor pixels;  ///< [n, points, 2]
  int width = 0, height = 0;
};

/// Mean distance between the true and the predicted image of the points, in hundredths of the image's width:
/// reprojection_error_px() as a differentiable function of `predicted`, [n, 8] standardised outputs in
/// `space`. Computed on the device of `predicted`. The predicted H-FOV is clamped to 1°…179°, outside which
/// there is no camera.
torch::Tensor reprojection_loss(const torch::Tensor& predicted, const RayBatch& rays, TargetSpace space,
                                const Standardisation& by);

}  // namespace cps
