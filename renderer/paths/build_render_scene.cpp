#include "renderer/paths/build_render_scene.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "renderer/geometry/place_geometry.h"
#include "renderer/paths/render_scene.h"

namespace cps {

namespace {

/// Radiance of white unlit materials: that of white paper on level ground.
float unlit_white(const SkyAndSun& light) {
  const Color sunlight = light.sun.radiance / light.sun.pdf * std::max(0.0f, light.sun.direction.y());
  return luminance(horizontal_irradiance(light.sky) + sunlight) * std::numbers::inv_pi_v<float>;
}

std::vector<Eigen::Affine3f> riding_transforms(const PlacedGeometry& placed) {
  std::vector<Eigen::Affine3f> transforms;
  for (const Placement& placement : placed.placements)
    if (placement.rides) transforms.push_back(placement.world_from_mesh);
  return transforms;
}

/// Of what rides with the car.
Eigen::AlignedBox3f riding_bounds(const PlacedGeometry& placed) {
  Eigen::AlignedBox3f bounds;
  for (const Placement& placement : placed.placements) {
    if (!placement.rides) continue;
    for (const PackedVertex& vertex : placed.geometries[placement.geometry].vertices)
      bounds.extend(placement.world_from_mesh * vertex.position);
  }
  return bounds;
}

}  // namespace

RenderScene::RenderScene(const Scene& scene, SkyAndSun light)
    : materials(make_materials(scene, unlit_white(light))),
      placed(place_geometry(scene, materials)),
      vehicle_from_mesh(riding_transforms(placed)),
      car_bounds(riding_bounds(placed)),
      bvh(placed),
      lamps(make_lamps(scene, placed)),
      sky(std::move(light.sky)),
      sun(light.sun) {}

std::shared_ptr<RenderScene> build_render_scene(const Scene& scene, const Daylight& daylight) {
  if (const std::string fault = daylight.fault(); !fault.empty()) throw std::runtime_error(fault);
  return std::make_shared<RenderScene>(scene, make_sky_and_sun(daylight));
}

void put_car(RenderScene& scene, const Eigen::Isometry3d& world_from_vehicle) {
  if (scene.vehicle_from_mesh.empty()) return;
  auto vehicle_from_mesh = scene.vehicle_from_mesh.begin();
  for (Placement& placement : scene.placed.placements) {
    if (!placement.rides) continue;
    placement.world_from_mesh = world_from_vehicle.cast<float>() * *vehicle_from_mesh++;
    placement.normal_from_mesh = placement.world_from_mesh.linear().inverse().transpose();
  }
  scene.car_bounds = riding_bounds(scene.placed);
  scene.bvh.move_riding(scene.placed);
}

}  // namespace cps
