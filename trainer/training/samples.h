#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dataset/labels/reader.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/calibration/targets.h"
#include "trainer/images/image_cache.h"

namespace cps {

/// Indices into dataset.images of one part, in the split list's order.
std::vector<int> images_of(const Dataset& dataset, Part part);

/// One part of a dataset, ready to be learned from: entry i of every list belongs to one image. Pixels and
/// numbers only: no path and no file order gets past here.
struct Samples {
  ImageCache cache;
  std::vector<Outputs> targets;           ///< in the space asked for, not standardised
  std::vector<Outputs> mirrored_targets;  ///< of the flipped images
  std::vector<std::string> skipped;       ///< one line for each image left out
  std::vector<std::shared_ptr<const RayGrid>> rays, mirrored_rays;  ///< empty unless asked for
};

struct SampleOptions {
  TargetSpace space = TargetSpace::apparent;
  Reduction reduction;
  bool with_rays = false;        ///< for the reprojection loss
  bool skip_bad_images = false;  ///< leave out what load_image_cache() refuses
};

/// Throws std::runtime_error with one line when the part is empty, an image is bad, or a label holds a number
/// that is not finite or, with rays, is not one-to-one.
Samples load_samples(const Dataset& dataset, Part part, const SampleOptions& options,
                     const std::filesystem::path& cache_file);

}  // namespace cps
