#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "dataset/reader.h"
#include "trainer/gray_image.h"

namespace cps {

/// The reduced gray images of (a part of) a dataset. Decoding PNG costs several times more than everything
/// else a training step does with an image, so it is done once.
struct ImageCache {
  std::vector<GrayView> images;                ///< in the order of the list they were asked for in
  std::vector<ImageSize> originals;            ///< sizes before reduction
  bool was_decoded = false;                    ///< false: found ready on disk
  std::shared_ptr<const std::uint8_t> memory;  ///< what the views point into
};

/// Images `images` (indices into dataset.images), from `file` when it holds exactly these images, with sizes
/// and modification times unchanged, at this reduction; else decoded (in parallel) and written to `file` by
/// atomic rename. The file is memory-mapped. An empty `file` keeps everything in plain memory. Throws
/// std::runtime_error with one line that names the image that is missing, corrupt, or not of its label's
/// size.
ImageCache load_image_cache(const Dataset& dataset, std::span<const int> images, const Reduction& reduction,
                            const std::filesystem::path& file);

}  // namespace cps
