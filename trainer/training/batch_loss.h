#pragma once

#include <torch/types.h>

#include <memory>
#include <span>

#include "trainer/calibration/reprojection.h"
#include "trainer/model/model_card.h"

namespace cps {

/// The truth about the images of a batch, which have one size.
struct BatchTruth {
  ImageSize size;                                    ///< before reduction
  std::vector<Outputs> targets;                      ///< not standardised
  std::vector<std::shared_ptr<const RayGrid>> rays;  ///< for the reprojection loss only
};

/// The loss that the model is trained by, of what it says ([n, 8], standardised) of a batch.
torch::Tensor batch_loss(const torch::Tensor& said, const BatchTruth& truth, const ModelCard& card);

}  // namespace cps
