#pragma once

#include "tests/renderer/handmade.h"

namespace cps {

/// A floor 1.65 m below the camera of a rig that stands at the origin, and a sphere in front of it.
inline Scene floor_and_sphere() {
  using namespace handmade;
  Scene scene;
  scene.objects = {"floor", "sphere"};
  scene.materials = {material({0.8f, 0.1f, 0.1f, 1}), material({0.1f, 0.2f, 0.9f, 1})};
  scene.meshes = {quad({-400, 0, 400}, {800, 0, 0}, {0, 0, -800}), sphere(1, 1, 256)};
  scene.instances = {
      {.mesh = 0, .world_from_mesh = Eigen::Affine3f::Identity(), .object = 0},
      {.mesh = 1, .world_from_mesh = Eigen::Affine3f(Eigen::Translation3f(7, 1.5f, 0.5f)), .object = 1}};
  return scene;
}

}  // namespace cps
