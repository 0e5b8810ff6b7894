#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dataset/labels/reader.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/calibration/targets.h"
#include "trainer/deepcalib/sphere_target.h"
#include "trainer/images/image_cache.h"
#include "trainer/model/head.h"

namespace cps {

/// The images of one part, as indices into dataset.images, in the order of the split list.
std::vector<int> images_of(const Dataset& dataset, Part part);

/// One part of a dataset, prepared for training: entry i of every list belongs to one image. Holds pixels and
/// numbers only, so that a network cannot learn from file names or their order.
struct Samples {
  ImageCache cache;
  std::vector<Outputs> targets;           ///< in the requested space, not standardised; or empty, and
  std::vector<Outputs> mirrored_targets;  ///< of the flipped images
  std::vector<SphereTarget> spheres;      ///< for a DeepCalib head: of the images, flipped or not
  std::vector<std::string> skipped;       ///< one line for each image left out
  std::vector<std::shared_ptr<const RayGrid>> rays, mirrored_rays;  ///< empty unless requested
};

/// Throws std::runtime_error in one line that starts with a label's file if a network with this head cannot
/// learn a label of the dataset's train or val part: its lens is of another family or, for a DeepCalib head,
/// not within what to_sphere_target() takes.
void require_learnable(const Dataset& dataset, Head head);

/// What load_samples() prepares.
struct SampleOptions {
  Head head = Head::brown_conrady;
  TargetSpace space = TargetSpace::apparent;
  Reduction reduction;
  OrientationOptions orientation{};
  bool with_rays = false;        ///< for the reprojection loss
  bool skip_bad_images = false;  ///< leave out images that load_image_cache() refuses
  double places_share = 1;       ///< load the images of such a share_of_places() alone
};

/// Loads one part of the dataset, with its pixels from `cache_file` where that is up to date. Throws
/// std::runtime_error with one line if the part is empty, an image is bad, a lens is of another family, a
/// label holds a number that is not finite, or (with rays) a label's lens is not one-to-one.
Samples load_samples(const Dataset& dataset, Part part, const SampleOptions& options,
                     const std::filesystem::path& cache_file);

}  // namespace cps
