#pragma once

#include <torch/types.h>

#include <vector>

#include "trainer/network/resnet.h"
#include "trainer/training/ranks.h"

namespace cps {

/// The sums of one step over its batches, in one tensor so that they are sent at once: gradients, statistics
/// of batch normalisation, the loss of all images, and the number of batches.
class StepSums {
 public:
  /// Starts a step of `network`, which must outlive this.
  explicit StepSums(Network& network);

  /// Call before each batch: resets the statistics to those at the start of the step.
  void begin_batch();

  /// Call after each batch: adds its gradients and statistics, and the sum of its images' losses.
  void add_batch(double loss_of_images);

  /// Sets gradients and buffers to their means over all batches of all processes. Returns the sum of the
  /// losses.
  double finish(const Ranks& ranks);

 private:
  std::vector<torch::Tensor> parameters_, buffers_, before_;
  std::vector<torch::Tensor> counts_, after_;  ///< num_batches_tracked
  torch::Tensor row_;
};

}  // namespace cps
