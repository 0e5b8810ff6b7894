#include "trainer/training/batch_loader.h"

#include <chrono>
#include <utility>

#include "numbers/wall_time.h"
#include "trainer/network/tensor_batch.h"

namespace cps {

LoadedBatch load_batch(const TrainingSet& set, const Batch& batch, const ModelCard& card, int epoch) {
  LoadedBatch loaded;
  loaded.shown = show(set, batch, card.options, epoch);
  loaded.images = network_images(loaded.shown);
  loaded.pixels = image_tensor(loaded.images, card.pixels);
  loaded.sizes = size_tensor(loaded.images);
  loaded.orientation = orientation_tensors(loaded.images, card);
  return loaded;
}

BatchLoader::BatchLoader(const TrainingSet& set, std::vector<Batch> batches, const ModelCard& card, int epoch)
    : set_(set), batches_(std::move(batches)), card_(card), epoch_(epoch) {
  prepare();
}

void BatchLoader::prepare() {
  if (begun_ == batches_.size()) return;
  ahead_ = std::async(std::launch::async,
                      [this, &batch = batches_[begun_++]] { return load_batch(set_, batch, card_, epoch_); });
}

LoadedBatch BatchLoader::next() {
  const auto start = std::chrono::steady_clock::now();
  LoadedBatch batch = ahead_.get();
  waited_seconds_ += seconds_since(start);
  prepare();
  return batch;
}

}  // namespace cps
