#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "dataset/reader.h"
#include "trainer/gray_image.h"

namespace cps {

/// Some of a dataset's images cannot be used. what() is one line about the first and the number of others.
struct BadImages : std::runtime_error {
  std::vector<int> positions;        ///< in the list that was asked for, ascending
  std::vector<std::string> reasons;  ///< one line each, file first

  BadImages(std::vector<int> positions, std::vector<std::string> reasons);
};

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
/// BadImages for those that are missing, corrupt, or not of their label's size.
ImageCache load_image_cache(const Dataset& dataset, std::span<const int> images, const Reduction& reduction,
                            const std::filesystem::path& file);

}  // namespace cps
