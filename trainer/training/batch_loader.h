#pragma once

#include <torch/types.h>

#include <future>
#include <vector>

#include "trainer/images/batches.h"
#include "trainer/model/model_card.h"
#include "trainer/network/orientation_tensors.h"
#include "trainer/training/training_set.h"

namespace cps {

/// A batch as the network takes it.
struct LoadedBatch {
  std::vector<ShownImage> shown;   ///< the images with their targets
  std::vector<BatchImage> images;  ///< point into `shown`
  torch::Tensor pixels, sizes;     ///< image_tensor() and size_tensor() of `images`, on the CPU
  OrientationTensors orientation;  ///< orientation_tensors() of `images`, on the CPU
};

/// Prepares the images of a batch for an epoch, as show() does. A pure function of its arguments.
LoadedBatch load_batch(const TrainingSet& set, const Batch& batch, const ModelCard& card, int epoch);

/// Hands out the batches of an epoch in order. While one is in use, another thread prepares the next one (and
/// no more than that one).
class BatchLoader {
 public:
  /// Begins to prepare the first batch. `set` and `card` must outlive this.
  BatchLoader(const TrainingSet& set, std::vector<Batch> batches, const ModelCard& card, int epoch);
  BatchLoader(const BatchLoader&) = delete;
  BatchLoader& operator=(const BatchLoader&) = delete;

  /// The next batch, as load_batch() makes it; there must be one left. Waits until it is ready. Throws what
  /// preparing it threw; after that, there is no next batch.
  LoadedBatch next();

  /// Wall-clock time that next() has waited so far.
  double waited_seconds() const { return waited_seconds_; }

 private:
  void prepare();

  const TrainingSet& set_;
  const std::vector<Batch> batches_;
  const ModelCard& card_;
  const int epoch_;
  std::size_t begun_ = 0;
  double waited_seconds_ = 0;
  /// The last member: its destructor waits for the other thread, which uses the others.
  std::future<LoadedBatch> ahead_;
};

}  // namespace cps
