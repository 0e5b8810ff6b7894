#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "trainer/images/batches.h"
#include "trainer/images/pixel_statistics.h"
#include "trainer/model/train_options.h"
#include "trainer/training/samples.h"

namespace cps {

/// An image as training shows it in one epoch, and the truth about it.
struct ShownImage {
  GrayImage pixels;  ///< reduced, not flipped yet
  ImageSize original;
  bool is_mirrored = false;
  Outputs target{};                          ///< of what is shown, so flipped if it is; not standardised
  std::shared_ptr<const RayGrid> rays = {};  ///< the same; null unless the loss needs them
};

/// What is learned from.
struct TrainingSet {
  std::vector<ImageSize> originals;  ///< of each image, before reduction
  PixelStatistics pixels;            ///< what its images are normalised by
  Standardisation targets;           ///< and their targets
  std::vector<std::string> skipped;  ///< one line for each image left out
  /// Image i in an epoch: a pure function of both, to be called by many threads.
  std::function<ShownImage(int i, int epoch)> shown;
};

/// Images as they lie on disk, every second one flipped where the options say so.
TrainingSet fixed_images(std::shared_ptr<const Samples> samples, const TrainOptions& options);

/// A batch in an epoch, augmented; in parallel, and the same for any number of threads.
std::vector<ShownImage> show(const TrainingSet& set, const Batch& batch, const TrainOptions& options,
                             int epoch);

/// The images without their truth, as a network takes them. They point into `shown`.
std::vector<BatchImage> network_images(const std::vector<ShownImage>& shown);

}  // namespace cps
