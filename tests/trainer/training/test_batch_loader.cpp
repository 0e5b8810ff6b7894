#include <tbb/global_control.h>
#include <torch/types.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <future>
#include <stdexcept>

#include "random/counter_hash.h"
#include "trainer/training/batch_loader.h"
#include "trainer/training/epoch.h"

using namespace cps;

namespace {

/// Images of noise, of two sizes in turns, whose target is their number and the epoch.
TrainingSet noise_images(int count) {
  TrainingSet set{
      .originals = {}, .pixels = {.mean = 128, .deviation = 74}, .targets = {}, .skipped = {}, .shown = {}};
  set.targets.deviation.fill(1);
  for (int i = 0; i < count; ++i) set.originals.push_back(i % 2 ? ImageSize{40, 32} : ImageSize{32, 32});
  set.shown = [sizes = set.originals](int i, int epoch) {
    ShownImage image{.pixels = {sizes[i], std::vector<std::uint8_t>(pixel_count(sizes[i]))},
                     .original = sizes[i],
                     .is_mirrored = i % 3 == 0,
                     .target = {double(i), double(epoch)}};
    const Stream noise = substream(substream(make_stream(7, "noise"), epoch), i);
    for (std::size_t p = 0; p < image.pixels.pixels.size(); ++p)
      image.pixels.pixels[p] = static_cast<std::uint8_t>(random_bits(noise, p));
    return image;
  };
  return set;
}

ModelCard card_of(const TrainingSet& set) {
  ModelCard card;
  card.pixels = set.pixels;
  card.targets = set.targets;
  card.options.architecture = "resnet10-32";
  card.options.batch_size = 4;
  card.options.augmentation.probability = .5;
  return card;
}

std::vector<Batch> batches_of(const TrainingSet& set, int epoch) {
  return shuffled_batches(set.originals, 4, 0, epoch);
}

}  // namespace

TEST_CASE("the loader hands out what a loop would prepare in the same order for any number of threads") {
  const int epoch = 3;
  const TrainingSet set = noise_images(30);
  const ModelCard card = card_of(set);
  const std::vector<Batch> batches = batches_of(set, epoch);
  const std::size_t threads = GENERATE(1, 4);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  BatchLoader loader(set, batches, card, epoch);
  for (const Batch& batch : batches) {
    const LoadedBatch ours = loader.next(), serial = load_batch(set, batch, card, epoch);
    REQUIRE(ours.shown.size() == batch.size());
    for (std::size_t n = 0; n < batch.size(); ++n) {
      CHECK(ours.shown[n].target == Outputs{double(batch[n]), double(epoch)});
      CHECK(ours.images[n].gray.pixels == ours.shown[n].pixels.pixels.data());  // not those of a moved copy
    }
    CHECK(torch::equal(ours.pixels, serial.pixels));
    CHECK(torch::equal(ours.sizes, serial.sizes));
  }
  CHECK(loader.waited_seconds() >= 0);
}

TEST_CASE("the next batch is prepared while one is in use and none after it") {
  TrainingSet set = noise_images(24);
  const ModelCard card = card_of(set);
  const std::vector<Batch> batches = batches_of(set, 1);
  std::vector<int> batch_of(24);
  for (std::size_t b = 0; b < batches.size(); ++b)
    for (int i : batches[b]) batch_of[i] = static_cast<int>(b);

  std::atomic<int> handed = 0;  // calls of next() so far
  std::atomic<bool> is_too_early = false;
  std::vector<std::promise<void>> begun(24);
  set.shown = [&, plain = set.shown](int i, int epoch) {
    if (batch_of[i] > handed) is_too_early = true;
    begun[i].set_value();  // throws if an image is prepared twice
    return plain(i, epoch);
  };
  BatchLoader loader(set, batches, card, 1);
  for (std::size_t b = 0; b < batches.size(); ++b) {
    ++handed;
    const LoadedBatch batch = loader.next();
    if (b + 1 == batches.size()) break;
    // Without a further call, all images of the next batch are begun. The time is only when the test gives
    // up.
    for (int i : batches[b + 1])
      REQUIRE(begun[i].get_future().wait_for(std::chrono::minutes(1)) == std::future_status::ready);
  }
  CHECK_FALSE(is_too_early);
}

TEST_CASE("what preparing a batch throws reaches the caller at that batch") {
  TrainingSet set = noise_images(24);
  const ModelCard card = card_of(set);
  const std::vector<Batch> batches = batches_of(set, 1);
  set.shown = [plain = set.shown, bad = batches[2].front()](int i, int epoch) {
    if (i == bad) throw std::runtime_error("masters/7.exr: cannot be read as a master");
    return plain(i, epoch);
  };
  {
    BatchLoader loader(set, batches, card, 1);
    CHECK(loader.next().shown.size() == batches[0].size());
    CHECK(loader.next().shown.size() == batches[1].size());
    CHECK_THROWS_WITH(loader.next(), "masters/7.exr: cannot be read as a master");
  }
  {  // a loader that nobody asks again ends quietly
    BatchLoader loader(set, batches, card, 1);
    loader.next();
    loader.next();
  }
  TrainingState state = fresh_training_state(card.options);
  EpochReport report;
  report.epoch = 1;
  CHECK_THROWS_WITH(train_epoch(state, set, card, nullptr, Ranks(), report),
                    "masters/7.exr: cannot be read as a master");
  CHECK(state.steps == 2);
}
