#include "scenes/drive/file_frame.h"

#include <algorithm>
#include <vector>

#include "scenes/enclosures.h"

namespace cps {
namespace {

/// Height between the 5th and 95th percentile of all vertices, so that a mast or a mountain backdrop does not
/// count.
double typical_height(const Scene& scene) {
  std::vector<float> heights;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (mesh.is_enclosure) continue;
    for (const Eigen::Vector3f& position : mesh.positions)
      heights.push_back((instance.world_from_mesh * position).y());
  }
  if (heights.empty()) return 0;
  std::sort(heights.begin(), heights.end());
  return heights[heights.size() - 1 - heights.size() / 20] - heights[heights.size() / 20];
}

}  // namespace

double guess_unit_scale(const Scene& scene) {
  const Eigen::Vector3d size = bounds_without_enclosures(scene).sizes().cast<double>();
  const double height = typical_height(scene), width = std::max(size.x(), size.z());
  // glTF is in metres. Only what no place is in metres is taken for something else: a town of towers higher
  // than 100 m that is hardly wider than they are high, or one that a person could step over.
  constexpr double max_height_m = 100, min_widths_per_height = 8, min_width_m = 8;
  double scale = 1;
  if (height > max_height_m && width < min_widths_per_height * height)
    while (scale * height > max_height_m) scale /= 10;
  while (width > 0 && scale * width < min_width_m) scale *= 10;
  return scale;
}

void turn_z_up(Scene& scene) {
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const Eigen::Matrix3f turn_f = turn.cast<float>();
  for (Instance& instance : scene.instances)
    if (!instance.rides) instance.world_from_mesh.prerotate(turn_f);
  for (PunctualLight& light : scene.lights) {
    light.position = turn_f * light.position;
    light.direction = turn_f * light.direction;
  }
  for (Lane& lane : scene.lanes)
    for (Eigen::Vector3f& point : lane.points) point = turn_f * point;
  for (SceneCamera& camera : scene.cameras) camera.world_from_camera.prerotate(turn);
  scene.origin = turn * scene.origin;
  const Eigen::AlignedBox3f bounds = scene.bounds;
  scene.bounds.setEmpty();
  scene.bounds.extend(turn_f * bounds.min()).extend(turn_f * bounds.max());
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
  scene.origin *= metres_per_unit;
  scene.bounds = Eigen::AlignedBox3f(scene.bounds.min() * s, scene.bounds.max() * s);
}

}  // namespace cps
