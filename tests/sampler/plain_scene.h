#pragma once

#include <string>

#include "scenes/scene.h"

namespace cps {

/// A bare ground plane, 400 m square, with `streets` parallel streets of two lanes each, 300 m long, running
/// along x.
inline Scene plain_scene(int streets) {
  Scene scene;
  scene.name = "plain";
  scene.materials.emplace_back();
  Mesh ground;
  ground.positions = {{-200, 0, -200}, {200, 0, -200}, {200, 0, 200}, {-200, 0, 200}};
  ground.normals.assign(4, {0, 1, 0});
  ground.uv0 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  ground.triangles = {{0, 2, 1}, {0, 3, 2}};
  scene.meshes.push_back(ground);
  scene.instances.emplace_back();
  scene.bounds.extend(Eigen::Vector3f(-200, 0, -200)).extend(Eigen::Vector3f(200, 0, 200));
  for (int s = 0; s < streets; ++s) {
    const float z = -100.0f + 20.0f * static_cast<float>(s);
    scene.lanes.push_back({"street " + std::to_string(s), 3.5f, {{-150, 0, z + 2}, {150, 0, z + 2}}});
    scene.lanes.push_back({"street " + std::to_string(s), 3.5f, {{150, 0, z - 2}, {-150, 0, z - 2}}});
  }
  return scene;
}

}  // namespace cps
