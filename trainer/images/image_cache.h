#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dataset/labels/reader.h"
#include "trainer/images/gray_image.h"
#include "trainer/images/orientation/orientation.h"

namespace cps {

/// The reduced gray images of (a part of) a dataset, and the orientation of the pictures' edges. Decoding a
/// PNG takes several times longer than everything else that a training step does to prepare an image, so it
/// is done once.
struct ImageCache {
  std::vector<GrayView> images;                ///< in the order of the requested list
  std::vector<ImageSize> originals;            ///< sizes before reduction
  std::vector<OrientationView> orientations;   ///< without planes unless measured
  int decoded = 0;                             ///< how many were not found in the cache file
  std::shared_ptr<const std::uint8_t> memory;  ///< what the views point into
};

/// Loads the images `images` (indices into dataset.images) from `file` if it holds exactly these images of
/// this dataset at this reduction, with orientation measured as asked, and their files' sizes and
/// modification times are unchanged; otherwise decodes them and writes `file`, see load_blob_cache(). Without
/// orientation, the file is the same as before there was any. Throws BadBlobs for images that are missing,
/// corrupt, or not of their label's size, and whatever load_blob_cache() throws.
ImageCache load_image_cache(const Dataset& dataset, std::span<const int> images, const Reduction& reduction,
                            const std::filesystem::path& file, const OrientationOptions& orientation = {});

}  // namespace cps
