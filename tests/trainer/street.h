#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "dataset/labels/reader.h"
#include "trainer/calibration/targets.h"
#include "trainer/images/gray_image.h"

namespace cps {

/// A picture from which a network can learn the calibration, computed in a millisecond without the renderer:
/// a straight street between two rows of houses, seen from a car by `camera`. `place` selects the street and
/// the heading.
GrayImage render_street(const CalibratedCamera& camera, std::uint64_t place);

/// The same through any lens: `ray_at` gives the ray (camera frame, any length) behind a point of the image.
GrayImage render_street(const ImageSize& size,
                        const std::function<Eigen::Vector3d(const Eigen::Vector2d& pixel)>& ray_at,
                        std::uint64_t place);

/// Writes an 8-bit picture. Its folder must exist.
void write_png(const GrayImage& image, const std::filesystem::path& file);

/// H-FOV within 1° of `hfov_deg`; a lens drawn for its apparent strength, one-to-one in its frame, and a
/// shifted principal point. lens 0: no distortion.
CalibratedCamera draw_calibration(const ImageSize& size, double hfov_deg, std::uint64_t lens);

struct StreetDatasetOptions {
  std::vector<ImageSize> sizes{{160, 90}};
  int fields_of_view = 4;  ///< spread evenly over 35…110°
  int lenses_per_part = 2;
  int train_places = 4, val_places = 2, test_places = 2;  ///< per group; no place occurs in two parts
};

/// Writes a dataset of such streets and reads it back. No place and no lens occurs in two parts. Every size
/// gets the same number of groups.
Dataset make_street_dataset(const std::filesystem::path& root, const StreetDatasetOptions& options);

}  // namespace cps
