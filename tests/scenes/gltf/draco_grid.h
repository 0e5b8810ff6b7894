#pragma once

#include "tests/scenes/gltf/gltf_maker.h"

inline constexpr int grid_columns = 9;

/// Vertex (x, y) of the grid, 0 ≤ x, y < grid_columns.
Eigen::Vector3f grid_point(int x, int y);

/// A Draco-compressed bumpy grid. Its accessors have counts and types but no buffer views, as the
/// specification requires.
GltfMaker draco_grid();
