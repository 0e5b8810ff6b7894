#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// The angles that a distorted image really sees, radians: between the rays through the ends of the row and
/// of the column of the principal point, and between those through opposite corners (the wider of the two
/// diagonals).
struct TrueFov {
  double horizontal_rad = 0, vertical_rad = 0, diagonal_rad = 0;
};

/// By inversion, to the outer edges of the pixels. `box` is a rectangle of ideal points on which the lens is
/// certified; empty if the image sees beyond it.
std::optional<TrueFov> true_fov(const Distortion& lens, const Pinhole& camera,
                                const Eigen::AlignedBox2d& box);

}  // namespace cps
