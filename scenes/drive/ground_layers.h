#pragma once

#include <cstdint>
#include <vector>

#include "scenes/drive/surroundings.h"
#include "scenes/scene.h"
#include "scenes/scene_rays.h"

namespace cps {

/// Drivable surfaces of a scene on a square grid of columns: surfaces that face up, are no steeper than 25°
/// and have 2.2 m of headroom. A column has several where a bridge, a roof or a street lies over something
/// else.
struct GroundLayers {
  double cell_m = 0.5;
  Eigen::Vector2d corner = {0, 0};  ///< x and z of the first column
  int nx = 0, nz = 0;
  std::vector<int>
      first;  ///< of each column's surfaces, which follow one another; one entry more than columns
  std::vector<Eigen::Vector3f> surfaces;  ///< world
  std::vector<std::uint8_t> is_open;      ///< whether nothing is above
  std::vector<int> east, south;      ///< the surface that a car can drive to in the next column; −1: none
  std::vector<Surroundings> around;  ///< of the surfaces of sample columns; nothing of others
  std::vector<int> piece;            ///< connected piece of each surface
  int pieces = 0;
};

/// Every fourth column in x and in z is a sample column.
constexpr int sample_stride = 4;

/// Height of a car's bonnet above the ground.
constexpr double bonnet_m = 1.1;

/// Finds them by ray casting: downwards for the surfaces, and between neighbouring columns at bumper and
/// bonnet height for obstacles. A piece ends at a step of more than 0.2 m or a slope of more than 25°.
GroundLayers ground_layers(const Scene& scene, const SceneRays& rays);

}  // namespace cps
