#pragma once

#include <torch/types.h>

#include <vector>

#include "trainer/network/resnet.h"
#include "trainer/training/ranks.h"

namespace cps {

/// What a step sums over its batches, in one row so that it is sent at once: gradients, what batch
/// normalisation has counted, the loss of all images, and the number of batches.
class StepSums {
 public:
  explicit StepSums(Network& network);

  /// Each batch starts from the statistics that the step started from.
  void begin_batch();

  void add_batch(double loss_of_images);

  /// Puts the means over all batches of all processes into gradients and buffers. Returns the losses' sum.
  double finish(const Ranks& ranks);

 private:
  std::vector<torch::Tensor> parameters_, buffers_, before_;
  std::vector<torch::Tensor> counts_, after_;  ///< num_batches_tracked
  torch::Tensor row_;
};

}  // namespace cps
