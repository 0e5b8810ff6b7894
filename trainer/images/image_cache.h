#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dataset/labels/reader.h"
#include "trainer/images/gray_image.h"

namespace cps {

/// The reduced gray images of (a part of) a dataset. Decoding PNG costs several times more than everything
/// else a training step does with an image, so it is done once.
struct ImageCache {
  std::vector<GrayView> images;                ///< in the order of the list they were asked for in
  std::vector<ImageSize> originals;            ///< sizes before reduction
  int decoded = 0;                             ///< how many were not found ready on disk
  std::shared_ptr<const std::uint8_t> memory;  ///< what the views point into
};

/// Images `images` (indices into dataset.images), from `file` when it holds exactly these images of this
/// dataset, with sizes and modification times unchanged, at this reduction; else decoded, as
/// load_blob_cache() makes things. Throws BadBlobs for those that are missing, corrupt, or not of their
/// label's size, and as load_blob_cache() does.
ImageCache load_image_cache(const Dataset& dataset, std::span<const int> images, const Reduction& reduction,
                            const std::filesystem::path& file);

}  // namespace cps
