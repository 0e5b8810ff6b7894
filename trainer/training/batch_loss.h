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
};

/// The training loss of a batch, as card.options define it. `predicted`: [n, 8], standardised.
torch::Tensor batch_loss(const torch::Tensor& predicted, const BatchTruth& truth, const ModelCard& card);

}  // namespace cps
