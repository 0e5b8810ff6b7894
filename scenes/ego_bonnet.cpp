#include "scenes/ego_bonnet.h"

#include <algorithm>
#include <cmath>

namespace cps {
namespace {

constexpr int along_cells = 24, across_cells = 32;
constexpr float screen_x_m = 2.15f, front_x_m = 3.55f, screen_height_m = 1.0f;

/// A point of the bonnet in the vehicle frame: `along` from the windscreen (0) to the grille (1), `across`
/// from the right wing (−1) to the left (1).
Eigen::Vector3f bonnet_point(float along, float across) {
  const float half_width_m = 0.86f - 0.12f * along * along;
  const float fall_m = 0.14f * std::pow(along, 1.6f) + 0.18f * std::pow(along, 12.0f);
  const float wing_m = 0.07f * across * across + 0.12f * std::pow(across, 8.0f);
  return {screen_x_m + along * (front_x_m - screen_x_m), half_width_m * across,
          screen_height_m - fall_m - wing_m};
}

Mesh bonnet_mesh(int material) {
  Mesh mesh;
  mesh.name = "ego bonnet";
  mesh.material = material;
  const auto point = [](int i, int j) {
    return bonnet_point(static_cast<float>(i) / along_cells, 2 * static_cast<float>(j) / across_cells - 1);
  };
  for (int i = 0; i <= along_cells; ++i)
    for (int j = 0; j <= across_cells; ++j) {
      mesh.positions.push_back(point(i, j));
      const Eigen::Vector3f forward = point(std::min(i + 1, along_cells), j) - point(std::max(i - 1, 0), j);
      const Eigen::Vector3f left = point(i, std::min(j + 1, across_cells)) - point(i, std::max(j - 1, 0));
      mesh.normals.push_back(forward.cross(left).normalized());
      mesh.uv0.emplace_back(static_cast<float>(i) / along_cells, static_cast<float>(j) / across_cells);
    }
  for (int i = 0; i < along_cells; ++i)
    for (int j = 0; j < across_cells; ++j) {
      const int corner = i * (across_cells + 1) + j, ahead = corner + across_cells + 1;
      mesh.triangles.emplace_back(corner, ahead, ahead + 1);
      mesh.triangles.emplace_back(corner, ahead + 1, corner + 1);
    }
  return mesh;
}

}  // namespace

void add_ego_bonnet(Scene& scene) {
  Material paint;
  paint.name = "ego paint";
  paint.base_color = {0.05f, 0.06f, 0.08f, 1.0f};
  paint.metallic = 0;
  paint.roughness = 0.2f;
  scene.materials.push_back(paint);
  scene.meshes.push_back(bonnet_mesh(static_cast<int>(scene.materials.size()) - 1));
  scene.objects.emplace_back("ego vehicle");
  Instance instance;
  instance.mesh = static_cast<int>(scene.meshes.size()) - 1;
  instance.rides = true;
  instance.object = static_cast<int>(scene.objects.size()) - 1;
  scene.instances.push_back(instance);
}

}  // namespace cps
