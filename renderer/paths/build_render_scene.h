#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "scenes/daylight.h"
#include "scenes/scene.h"

namespace cps {

/// A scene ready to be traced under one light: BVH, mip pyramids, sky tables. Built once per condition.
struct RenderScene;
std::shared_ptr<RenderScene> build_render_scene(const Scene& scene, const Daylight& daylight);

/// Moves what rides with the car (Instance::rides), as its bonnet does. Not while the scene is rendered.
void put_car(RenderScene& scene, const Eigen::Isometry3d& world_from_vehicle);

}  // namespace cps
