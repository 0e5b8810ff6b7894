#pragma once

#include <cstdint>
#include <vector>

#include "scenes/drive/surroundings.h"
#include "scenes/scene.h"
#include "scenes/scene_rays.h"

namespace cps {

/// The ground of a scene that a car drives on: the street piece of its GroundLayers, on their grid.
struct GroundGrid {
  double cell_m = 0.5;
  Eigen::Vector2d corner = {0, 0};  ///< x and z of the first cell's centre
  int nx = 0, nz = 0;
  std::vector<float> height;              ///< y; NaN without ground
  std::vector<std::uint8_t> east, south;  ///< whether a car can drive to the next cell in x, in z
  std::vector<float> room_m;              ///< distance to the ground's edge; 0 outside it
  std::vector<Surroundings> around;       ///< nothing outside the ground
  double area_m2 = 0;
  double level_m = 0;  ///< mean height
  int rivals = 0;      ///< StreetPiece::rivals

  int index(int x, int z) const { return z * nx + x; }
  /// The cell whose centre is nearest to a point (x, z); −1 outside the grid.
  int cell_at(const Eigen::Vector2d& point) const;
  /// `room_m` at a point (x, z); 0 outside the grid.
  double room_at(const Eigen::Vector2d& point) const;
  /// `around` at a point (x, z); nothing outside the grid.
  Surroundings around_at(const Eigen::Vector2d& point) const;
  /// The ground point (world) at (x, z).
  Eigen::Vector3d ground_at(const Eigen::Vector2d& point) const;
};

/// Finds it. Without a street all heights are NaN and the area is 0.
GroundGrid ground_grid(const Scene& scene, const SceneRays& rays);

}  // namespace cps
