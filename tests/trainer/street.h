#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "dataset/labels/reader.h"
#include "trainer/calibration/targets.h"
#include "trainer/images/gray_image.h"

namespace cps {

/// A picture a network can learn calibration from, made in a millisecond and without the renderer: a straight
/// street between two rows of houses, seen from a car through `calibration`'s lens. `place` chooses the
/// street and the heading.
GrayImage render_street(const Calibration& calibration, std::uint64_t place);

/// H-FOV within 1° of `hfov_deg`; a lens drawn for its apparent strength, one-to-one in its frame, and a
/// shifted principal point. lens 0: no distortion.
Calibration draw_calibration(const ImageSize& size, double hfov_deg, std::uint64_t lens);

struct StreetDatasetOptions {
  std::vector<ImageSize> sizes{{160, 90}};
  int fields_of_view = 4;  ///< spread evenly over 35…110°
  int lenses_per_part = 2;
  int train_places = 4, val_places = 2, test_places = 2;  ///< per group; no place occurs in two parts
};

/// Writes a dataset of such streets, read back as any other; no place and no lens in two parts. Every size
/// gets the same number of groups.
Dataset make_street_dataset(const std::filesystem::path& root, const StreetDatasetOptions& options);

}  // namespace cps
