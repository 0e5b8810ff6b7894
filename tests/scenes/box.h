#pragma once

#include "scenes/scene.h"

namespace cps {

/// A box with outward faces, its corners at ±1.
inline Mesh box() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

/// Adds a box with these corners to a scene whose first mesh is box().
inline void add_box(Scene& scene, const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  Instance instance;
  instance.world_from_mesh =
      Eigen::Translation3f((low + high) / 2) * Eigen::Scaling(Eigen::Vector3f((high - low) / 2));
  scene.instances.push_back(instance);
  scene.bounds.extend(low).extend(high);
}

}  // namespace cps
