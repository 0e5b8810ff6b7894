#pragma once

#include <torch/types.h>

#include <vector>

#include "trainer/batches.h"
#include "trainer/model_card.h"
#include "trainer/samples.h"

namespace cps {

/// The loss that the model is trained by, of what it says ([n, 8], standardised) of a batch of samples;
/// `mirrored`, empty or one per image, tells which were shown flipped.
torch::Tensor batch_loss(const torch::Tensor& said, const Samples& samples, const Batch& batch,
                         const std::vector<bool>& mirrored, const ModelCard& card);

}  // namespace cps
