#pragma once

#include "scenes/scene.h"

namespace cps {

/// How the coordinates in a scene's file lead to the scene as it is rendered.
struct FileFrame {
  double metres_per_unit = 1;
  bool is_z_up = false;
  Eigen::Vector3d origin = {0, 0, 0};  ///< Scene::origin, metres, y up
};

/// The metres per unit of a scene that does not say: 1, as glTF demands, unless no place looks like that in
/// metres: towers all higher than 100 m on a ground hardly wider than they are high, or a town less than 8 m
/// wide. Then the power of ten nearest to 1 with which it is neither.
double guess_unit_scale(const Scene& scene);

/// Turns a scene whose z points up so that y does, as glTF demands: (x, y, z) becomes (x, z, −y).
void turn_z_up(Scene& scene);

/// Multiplies all lengths of the scene: instances, lanes, lights, cameras. The lights' intensities grow with
/// the square, so that surfaces are as bright as before.
void scale_scene(Scene& scene, double metres_per_unit);

}  // namespace cps
