#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "scenes/daylight.h"
#include "scenes/scene.h"

namespace cps {

struct RenderScene;

/// Prepares a scene for rendering under one light: builds BVH, mip pyramids and sky tables. Done once per
/// condition; render() then takes any number of views. Throws std::runtime_error in one line for a fault of
/// the scene or the daylight.
std::shared_ptr<RenderScene> build_render_scene(const Scene& scene, const Daylight& daylight);

/// Moves what rides with the car (Instance::rides), such as its bonnet, to where the car is. Not while the
/// scene is rendered.
void put_car(RenderScene& scene, const Eigen::Isometry3d& world_from_vehicle);

}  // namespace cps
