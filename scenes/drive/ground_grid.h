#pragma once

#include <cstdint>
#include <vector>

#include "scenes/scene.h"
#include "scenes/scene_rays.h"

namespace cps {

/// The drivable ground of a scene on a square grid in the horizontal plane: in each cell the lowest surface
/// that faces up, is no steeper than 25° and has 2.2 m of room above it.
struct GroundGrid {
  double cell_m = 0.5;
  Eigen::Vector2d corner = {0, 0};  ///< x and z of the first cell's middle
  int nx = 0, nz = 0;
  std::vector<float> height;              ///< y, NaN where there is no ground
  std::vector<std::uint8_t> east, south;  ///< whether a car gets to the next cell in x, in z
  std::vector<float> room_m;              ///< to where the largest connected piece ends; 0 outside it
  double area_m2 = 0;                     ///< of that piece

  int index(int x, int z) const { return z * nx + x; }
  /// The cell that a point (x, z) is nearest to; −1 beyond the grid.
  int cell_at(const Eigen::Vector2d& point) const;
  /// Room at a point, 0 beyond the grid.
  double room_at(const Eigen::Vector2d& point) const;
  /// The point on the ground (world).
  Eigen::Vector3d ground_at(const Eigen::Vector2d& point) const;
};

/// Found by casting rays: down for the ground, and between neighbouring cells at bumper and bonnet height for
/// what stands between them. A step of more than 0.2 m, or a slope beyond 25°, ends the ground.
GroundGrid ground_grid(const Scene& scene, const SceneRays& rays);

}  // namespace cps
