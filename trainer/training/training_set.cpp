#include "trainer/training/training_set.h"

#include <tbb/parallel_for.h>

namespace cps {

TrainingSet fixed_images(std::shared_ptr<const Samples> samples, const TrainOptions& options) {
  std::vector<Outputs> targets = samples->targets;
  if (options.mirror)
    targets.insert(targets.end(), samples->mirrored_targets.begin(), samples->mirrored_targets.end());
  const auto shown = [samples, seed = options.seed, mirror = options.mirror](int i, int epoch) {
    const GrayView& view = samples->cache.images[i];
    ShownImage image{.pixels = {view.size, {view.pixels, view.pixels + pixel_count(view.size)}},
                     .original = samples->cache.originals[i],
                     .is_mirrored = mirror && is_mirrored(seed, epoch, i)};
    image.target = (image.is_mirrored ? samples->mirrored_targets : samples->targets)[i];
    if (!samples->rays.empty()) image.rays = (image.is_mirrored ? samples->mirrored_rays : samples->rays)[i];
    return image;
  };
  return {.originals = samples->cache.originals,
          .pixels = pixel_statistics(samples->cache.images),
          .targets = fit_standardisation(targets),
          .skipped = samples->skipped,
          .shown = shown};
}

std::vector<ShownImage> show(const TrainingSet& set, const Batch& batch, const TrainOptions& options,
                             int epoch) {
  const Stream changes = substream(make_stream(options.seed, "augmentation"), epoch);
  std::vector<ShownImage> shown(batch.size());
  tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t n) {
    shown[n] = set.shown(batch[n], epoch);
    GrayImage& pixels = shown[n].pixels;
    if (options.augmentation.probability > 0)
      pixels =
          augmented({pixels.size, pixels.pixels.data()}, options.augmentation, substream(changes, batch[n]));
  });
  return shown;
}

std::vector<BatchImage> network_images(const std::vector<ShownImage>& shown) {
  std::vector<BatchImage> images;
  for (const ShownImage& image : shown)
    images.push_back({{image.pixels.size, image.pixels.pixels.data()}, image.original, image.is_mirrored});
  return images;
}

}  // namespace cps
