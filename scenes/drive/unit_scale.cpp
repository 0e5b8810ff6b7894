#include "scenes/drive/unit_scale.h"

#include <algorithm>
#include <vector>

namespace cps {
namespace {

/// Height between the 5th and 95th percentile of all vertices, so that a mast or a mountain backdrop does not
/// count.
double typical_height(const Scene& scene) {
  std::vector<float> heights;
  for (const Instance& instance : scene.instances)
    for (const Eigen::Vector3f& position : scene.meshes[instance.mesh].positions)
      heights.push_back((instance.world_from_mesh * position).y());
  if (heights.empty()) return 0;
  std::sort(heights.begin(), heights.end());
  return heights[heights.size() - 1 - heights.size() / 20] - heights[heights.size() / 20];
}

}  // namespace

double guess_unit_scale(const Scene& scene) {
  const Eigen::Vector3d size = scene.bounds.sizes().cast<double>();
  const double height = typical_height(scene), width = std::max(size.x(), size.z());
  const auto is_high = [&](double scale) { return scale * height >= 3 && scale * height <= 60; };
  const auto is_wide = [&](double scale) { return scale * width >= 20 && scale * width <= 20'000; };
  constexpr double scales[] = {1, 0.1, 10, 0.01, 100, 0.001, 1000};
  for (const double scale : scales)
    if (is_high(scale) && is_wide(scale)) return scale;
  for (const double scale : scales)
    if (is_high(scale)) return scale;
  return 1;
}

void scale_scene(Scene& scene, double metres_per_unit) {
  const auto s = static_cast<float>(metres_per_unit);
  if (s == 1) return;
  for (Instance& instance : scene.instances) instance.world_from_mesh.prescale(s);
  for (PunctualLight& light : scene.lights) {
    light.position *= s;
    if (light.kind != PunctualLight::Kind::directional) light.intensity *= s * s;
  }
  for (Lane& lane : scene.lanes) {
    lane.width_m *= s;
    for (Eigen::Vector3f& point : lane.points) point *= s;
    for (LaneStretch& stretch : lane.occupied) {
      stretch.from_m *= metres_per_unit;
      stretch.to_m *= metres_per_unit;
    }
  }
  for (SceneCamera& camera : scene.cameras) camera.world_from_camera.translation() *= metres_per_unit;
  scene.bounds = Eigen::AlignedBox3f(scene.bounds.min() * s, scene.bounds.max() * s);
}

}  // namespace cps
