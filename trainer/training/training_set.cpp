#include "trainer/training/training_set.h"

#include <tbb/parallel_for.h>

#include "trainer/images/orientation/measure.h"

namespace cps {
namespace {

Orientation copy_of(const OrientationView& view) {
  if (!view.planes) return {};
  return {view.grid, {view.planes, view.planes + plane_bytes(view.grid)}, view.numbers};
}

void augment(ShownImage& image, const Augmentation& augmentation, Stream stream) {
  const bool is_measured_later = !image.measured.pixels.empty();
  GrayImage& changed = is_measured_later ? image.measured : image.pixels;
  Augmentation changes = augmentation;
  if (is_measured_later)
    changes.max_cutout = 0;  // the sides of the cut-out would be measured as straight edges
  changed = augmented({changed.size, changed.pixels.data()}, changes, stream);
  if (is_measured_later) image.pixels = area_average(image.measured, image.pixels.size);
}

/// Measures the orientation if that is left to do.
void measure(ShownImage& image) {
  if (image.measured.pixels.empty()) return;
  image.orientation = orientation_of({image.measured.size, image.measured.pixels.data()}, image.pixels.size);
  image.measured = {};
}

}  // namespace

TrainingSet fixed_images(std::shared_ptr<const Samples> samples, const TrainOptions& options) {
  const bool has_spheres = is_deepcalib(options.head);
  const auto shown = [samples, has_spheres, seed = options.seed, mirror = options.mirror](int i, int epoch) {
    const GrayView& view = samples->cache.images[i];
    ShownImage image{.pixels = {view.size, {view.pixels, view.pixels + pixel_count(view.size)}},
                     .original = samples->cache.originals[i],
                     .is_mirrored = mirror && is_mirrored(seed, epoch, i)};
    image.orientation = copy_of(samples->cache.orientations[i]);
    if (has_spheres)
      image.sphere = samples->spheres[i];
    else
      image.target = (image.is_mirrored ? samples->mirrored_targets : samples->targets)[i];
    if (!samples->rays.empty()) image.rays = (image.is_mirrored ? samples->mirrored_rays : samples->rays)[i];
    return image;
  };
  TrainingSet set{.originals = samples->cache.originals,
                  .pixels = pixel_statistics(samples->cache.images),
                  .orientation = options.orientation.measured
                                     ? orientation_statistics(samples->cache.orientations)
                                     : OrientationStatistics{},
                  .targets = {},
                  .skipped = samples->skipped,
                  .shown = shown};
  if (has_spheres) {
    set.spheres = sphere_statistics(samples->spheres);
  } else {
    std::vector<Outputs> targets = samples->targets;
    if (options.mirror)
      targets.insert(targets.end(), samples->mirrored_targets.begin(), samples->mirrored_targets.end());
    set.targets = fit_standardisation(targets);
    set.correlation = correlation(targets);
  }
  return set;
}

std::vector<ShownImage> show(const TrainingSet& set, const Batch& batch, const TrainOptions& options,
                             int epoch) {
  const Stream changes = substream(make_stream(options.seed, "augmentation"), epoch);
  std::vector<ShownImage> shown(batch.size());
  tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t n) {
    shown[n] = set.shown(batch[n], epoch);
    if (options.augmentation.probability > 0)
      augment(shown[n], options.augmentation, substream(changes, batch[n]));
    measure(shown[n]);
  });
  return shown;
}

std::vector<BatchImage> network_images(const std::vector<ShownImage>& shown) {
  std::vector<BatchImage> images;
  for (const ShownImage& image : shown)
    images.push_back({{image.pixels.size, image.pixels.pixels.data()},
                      image.original,
                      image.is_mirrored,
                      view_of(image.orientation)});
  return images;
}

}  // namespace cps
