#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// The angles that a distorted image really sees, radians. Horizontal: between the rays through the left and
/// the right end of the principal point's row. Vertical: through the top and the bottom end of its column.
/// Diagonal: the larger of two angles, between the rays through the top-left and the bottom-right corner and
/// between those through the bottom-left and the top-right corner; an off-centre lens makes them differ.
struct TrueFov {
  double horizontal_rad = 0, vertical_rad = 0, diagonal_rad = 0;
};

/// Computed by inverting the lens at the frame's edges (outer edges of the pixels, not their centres). `box`
/// is a rectangle of ideal points on which the lens is certified; empty if the image sees beyond it.
std::optional<TrueFov> true_fov(const Distortion& lens, const Pinhole& camera,
                                const Eigen::AlignedBox2d& box);

}  // namespace cps
