#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "trainer/calibration/lens_posterior.h"
#include "trainer/images/batches.h"
#include "trainer/images/orientation/orientation_statistics.h"
#include "trainer/images/pixel_statistics.h"
#include "trainer/model/train_options.h"
#include "trainer/training/samples.h"

namespace cps {

/// An image as the network sees it in one epoch, with its target.
struct ShownImage {
  GrayImage pixels;  ///< reduced, not flipped yet
  ImageSize original;
  bool is_mirrored = false;
  Outputs target{};                          ///< of the image as shown, flipped if it is; not standardised
  SphereTarget sphere{};                     ///< the same for a DeepCalib head, which does not use `target`
  std::shared_ptr<const RayGrid> rays = {};  ///< also of the image as shown; null unless the loss needs them
  Orientation orientation{};  ///< of the image before it is flipped; without planes unless the network has it
  /// The picture that show() augments, to measure the orientation in it and to reduce it to `pixels`. Empty
  /// if the orientation is known or not wanted; then show() augments `pixels`.
  GrayImage measured{};
};

/// The images that a network is trained on.
struct TrainingSet {
  std::vector<ImageSize> originals;     ///< of each image, before reduction
  PixelStatistics pixels;               ///< by which the images are normalised
  OrientationStatistics orientation{};  ///< by which their orientation is; zeros without orientation
  Standardisation targets;              ///< by which the targets are standardised
  OutputCovariance correlation = OutputCovariance::Identity();  ///< of the targets
  SphereStatistics spheres{};                                   ///< of the targets of a DeepCalib head
  std::vector<std::string> skipped;                             ///< one line for each image left out
  /// Image i in an epoch: a pure function of both, safe to call from many threads.
  std::function<ShownImage(int i, int epoch)> shown;
};

/// The stored images; a random half is flipped in each epoch if options.mirror is set. Their orientation is
/// that of the stored pictures: augmentation changes the reduced image alone, since pictures of full size are
/// not kept.
TrainingSet fixed_images(std::shared_ptr<const Samples> samples, const TrainOptions& options);

/// The images of a batch in an epoch, augmented, with their orientation. Computed in parallel, with the same
/// result for any number of threads.
std::vector<ShownImage> show(const TrainingSet& set, const Batch& batch, const TrainOptions& options,
                             int epoch);

/// The images without their targets, as a network takes them. They point into `shown`.
std::vector<BatchImage> network_images(const std::vector<ShownImage>& shown);

}  // namespace cps
