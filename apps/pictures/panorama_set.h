#pragma once

#include <filesystem>

#include "dataset/panorama_draw.h"

namespace cps {

/// Makes the dataset `root` of drawn views of every panorama in `folder` (not below it): images with their
/// labels, split lists, `panoramas.json` about where they come from, and, for families other than
/// Brown–Conrady, `dataset.json`, which says that it is not a CPS dataset. Panoramas of integers keep their
/// encoding; those of half and float are exposed and developed as renders are, with a sensor drawn for each
/// image. Every file is checked before the first image is made. Prints a summary. Throws std::runtime_error
/// in one line, file first: no panorama, one that is not twice as wide as high or too coarse, two of one
/// name.
void make_panorama_set(const std::filesystem::path& folder, const std::filesystem::path& root,
                       const PanoramaSetOptions& options);

}  // namespace cps
