#pragma once

#include <Eigen/Geometry>

#include "distortion/brown_conrady.h"

/// The unified model's plane, on which a unit ray (x, y, z) lands at (x, y) / (z + ξ).
namespace cps {

/// The part of the plane where rays land.
struct SphereReach {
  double max_angle_rad;  ///< up to which the radius on the plane provably grows with the angle
  double max_radius;     ///< where a ray at that angle lands; very large for ξ ≤ 1
};

/// ξ ≥ 0 (not checked). For ξ ≤ 1 rays land everywhere; for ξ > 1 within 1/√(ξ² − 1), where they arrive at
/// arccos(−1/ξ) from the axis.
SphereReach sphere_reach(double xi);

/// The angle from the axis, radians, of the ray that lands at `radius` ≤ max_radius.
double angle_on_sphere(double xi, double radius);

/// Whether the lens provably keeps the part of the circle of `radius` about the principal point that lies in
/// `box` out of the inside of `frame`. If the lens is one-to-one on the box and its image of the box contains
/// the frame, then so does its image of the part of the box within the circle: what it sends into the frame
/// is connected and contains the principal point, so it cannot lie on both sides of the circle without
/// meeting it.
bool keeps_circle_out(const Distortion& lens, const Eigen::AlignedBox2d& box, double radius,
                      const Eigen::AlignedBox2d& frame);

}  // namespace cps
