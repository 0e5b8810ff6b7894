#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "distortion/image_size.h"

/// The orientation of a picture's edges, measured where it is to be seen: at the picture's own size, not at
/// the network's. A lens bends straight edges by a fraction of a degree, and averaging to the network's size
/// loses that. Edges are near-vertical where |gx| > 4 |gy|, near-horizontal where |gy| > 4 |gx| (gx, gy: the
/// picture's slope to the right and downwards); others are not used. The tilt of a near-vertical edge is
/// gy / gx: minus the pixels that the edge moves to the right on its way one pixel down. That of a
/// near-horizontal edge is gx / gy: minus the pixels that it moves down on its way one pixel to the right.
/// Tilts lie in (−1/4, 1/4). None of this changes with brightness or contrast.
namespace cps {

/// Whether and where orientation is measured.
struct OrientationOptions {
  bool measured = false;
  /// A wider picture is reduced to this width first, in pixels (but never below the network's image).
  int max_width = 1392;

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
  bool operator==(const OrientationOptions&) const = default;
};

/// Near-vertical and near-horizontal edges.
inline constexpr int edge_families = 2;

/// The numbers of a picture, by fit_tilt(): those of the near-vertical edges, then those of the others.
inline constexpr int tilt_terms = 6, numbers_per_family = 2 * tilt_terms + 2,
                     orientation_number_count = edge_families * numbers_per_family;
using OrientationNumbers = std::array<float, orientation_number_count>;

/// "vertical_tilt_xy", "horizontal_share", …, in their order.
extern const std::array<std::string, orientation_number_count> orientation_number_names;

/// Planes of a picture, in their order: tilt of near-vertical and of near-horizontal edges, then the
/// confidence in each.
inline constexpr int orientation_plane_count = 2 * edge_families;

/// What one step of a plane stands for: tilts are round(tilt · 508), confidences round(confidence · 127).
inline constexpr double tilt_steps_per_unit = 508, confidence_steps_per_unit = 127;

/// The orientation of one picture.
struct Orientation {
  ImageSize grid;  ///< cells of a plane
  std::vector<std::int8_t>
      planes;  ///< orientation_plane_count × grid, rows top to bottom; empty: not measured
  OrientationNumbers numbers{};
};

/// The same with planes that are owned elsewhere.
struct OrientationView {
  ImageSize grid;
  const std::int8_t* planes = nullptr;  ///< null: not measured
  OrientationNumbers numbers{};
};

inline OrientationView view_of(const Orientation& orientation) {
  return {orientation.grid, orientation.planes.empty() ? nullptr : orientation.planes.data(),
          orientation.numbers};
}

/// The cells for a network image of this size: one for each 2×2 of its pixels, as many as its first
/// convolution, of stride 2, has outputs.
inline ImageSize orientation_grid(const ImageSize& network_image) {
  return {(network_image.width + 1) / 2, (network_image.height + 1) / 2};
}

/// Bytes of all planes.
inline std::size_t plane_bytes(const ImageSize& grid) {
  return static_cast<std::size_t>(orientation_plane_count) * grid.width * grid.height;
}

/// The numbers of the picture flipped left to right. (Its planes are the planes flipped, tilts with the other
/// sign, but for a middle column of pixels whose centre lies on a boundary between cells.)
OrientationNumbers mirrored(const OrientationNumbers& numbers);

}  // namespace cps
