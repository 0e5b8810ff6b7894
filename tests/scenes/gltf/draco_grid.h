#pragma once

#include "tests/scenes/gltf/gltf_maker.h"

inline constexpr int grid_columns = 9;

/// Vertex (x, y) of the grid, 0 ≤ x, y < grid_columns.
Eigen::Vector3f grid_point(int x, int y);

/// A bumpy grid as one_square()'s primitive, compressed by Draco, with the accessors that the specification
/// asks for: counts and types, but no buffer views.
GltfMaker draco_grid();
