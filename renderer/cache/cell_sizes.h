#pragma once

#include <vector>

#include "scenes/scene.h"

namespace cps {

/// How large the light cache's cells are: by how far from a lane they lie, whoever looks.
struct CellSizes {
  float spacing_m = 1;
  Eigen::Vector2f corner = {0, 0};     ///< x and z of the first node
  int nx = 0, nz = 0;                  ///< nodes; 0: a scene without lanes
  std::vector<float> lane_distance_m;  ///< at the nodes, level distance to the nearest lane
  float lane_height_m = 0;             ///< mean y of all lanes

  /// Level of the cells at a point as a real number: grows by 1 where cells are twice as large.
  float level_at(const Eigen::Vector3f& position) const;
};

CellSizes make_cell_sizes(const Scene& scene);

}  // namespace cps
