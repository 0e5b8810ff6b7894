#pragma once

#include <torch/types.h>

#include <memory>
#include <span>

#include "trainer/calibration/reprojection.h"
#include "trainer/model/model_card.h"

namespace cps {

/// The true values for the images of a batch, which all have one size.
struct BatchTruth {
  ImageSize size;                                    ///< before reduction
  std::vector<Outputs> targets;                      ///< not standardised
  std::vector<std::shared_ptr<const RayGrid>> rays;  ///< for the reprojection loss only
  std::vector<SphereTarget> spheres = {};            ///< of a DeepCalib head, which does not use `targets`
};

/// The training loss of a batch, as card.options define it. `predicted`: head_rows() of its images. With a
/// fit, the loss of the outputs is joined by likelihood_loss() and folding_penalty().
torch::Tensor batch_loss(const torch::Tensor& predicted, const BatchTruth& truth, const ModelCard& card);

}  // namespace cps
