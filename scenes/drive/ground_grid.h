#pragma once

#include <cstdint>
#include <vector>

#include "scenes/scene.h"
#include "scenes/scene_rays.h"

namespace cps {

/// The drivable ground of a scene on a square grid in the horizontal plane. A cell's ground is the lowest
/// surface that faces up, is no steeper than 25° and has 2.2 m of headroom.
struct GroundGrid {
  double cell_m = 0.5;
  Eigen::Vector2d corner = {0, 0};  ///< x and z of the first cell's centre
  int nx = 0, nz = 0;
  std::vector<float> height;              ///< y; NaN without ground
  std::vector<std::uint8_t> east, south;  ///< whether a car can drive to the next cell in x, in z
  std::vector<float> room_m;  ///< distance to the edge of the largest connected piece; 0 outside it
  double area_m2 = 0;         ///< of the largest connected piece

  int index(int x, int z) const { return z * nx + x; }
  /// The cell whose centre is nearest to a point (x, z); −1 outside the grid.
  int cell_at(const Eigen::Vector2d& point) const;
  /// `room_m` at a point (x, z); 0 outside the grid.
  double room_at(const Eigen::Vector2d& point) const;
  /// The ground point (world) at (x, z).
  Eigen::Vector3d ground_at(const Eigen::Vector2d& point) const;
};

/// Finds the drivable ground by ray casting: downwards for the ground, and between neighbouring cells at
/// bumper and bonnet height for obstacles. Ground ends at a step of more than 0.2 m or a slope of more than
/// 25°.
GroundGrid ground_grid(const Scene& scene, const SceneRays& rays);

}  // namespace cps
