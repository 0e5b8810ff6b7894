#include "renderer/cache/cell_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/segment_distance.h"

namespace cps {
namespace {

constexpr float nearest_level = 2;     // half a metre
constexpr float fine_distance_m = 16;  // up to here; beyond, cells grow with the distance
constexpr int max_nodes_per_side = 256;

Eigen::Vector2f level_ground(const Eigen::Vector3f& point) {
  return {point.x(), point.z()};
}

float distance_to_lanes(const Eigen::Vector2f& point, const std::vector<Lane>& lanes) {
  float nearest = std::numeric_limits<float>::max();
  for (const Lane& lane : lanes)
    for (std::size_t i = 0; i + 1 < lane.points.size(); ++i)
      nearest = std::min(nearest, distance_to_segment<float>(level_ground(lane.points[i]),
                                                             level_ground(lane.points[i + 1]), point));
  return nearest;
}

}  // namespace

float CellSizes::level_at(const Eigen::Vector3f& position) const {
  if (nx == 0) return nearest_level;
  const Eigen::Vector2f at = (level_ground(position) - corner) / spacing_m;
  const float x = std::clamp(at.x(), 0.0f, static_cast<float>(nx - 1)),
              z = std::clamp(at.y(), 0.0f, static_cast<float>(nz - 1));
  const int x0 = std::min(static_cast<int>(x), nx - 2), z0 = std::min(static_cast<int>(z), nz - 2);
  const auto node = [&](int i, int j) { return lane_distance_m[(z0 + j) * nx + x0 + i]; };
  const float u = x - static_cast<float>(x0), v = z - static_cast<float>(z0);
  const float ground_m =
      (1 - v) * ((1 - u) * node(0, 0) + u * node(1, 0)) + v * ((1 - u) * node(0, 1) + u * node(1, 1));
  const float distance_m = std::hypot(ground_m, position.y() - lane_height_m);
  return nearest_level + std::log2(std::max(1.0f, distance_m / fine_distance_m));
}

CellSizes make_cell_sizes(const Scene& scene) {
  CellSizes sizes;
  std::size_t points = 0;
  Eigen::AlignedBox2f box;
  for (const Lane& lane : scene.lanes)
    for (const Eigen::Vector3f& point : lane.points) {
      box.extend(level_ground(point));
      sizes.lane_height_m += point.y();
      ++points;
    }
  if (points < 2) return sizes;
  sizes.lane_height_m /= static_cast<float>(points);
  if (!scene.bounds.isEmpty())
    box.extend(level_ground(scene.bounds.min())).extend(level_ground(scene.bounds.max()));
  sizes.spacing_m = std::max(8.0f, box.sizes().maxCoeff() / (max_nodes_per_side - 2));
  sizes.corner = box.min();
  sizes.nx = static_cast<int>(box.sizes().x() / sizes.spacing_m) + 2;
  sizes.nz = static_cast<int>(box.sizes().y() / sizes.spacing_m) + 2;
  for (int j = 0; j < sizes.nz; ++j)
    for (int i = 0; i < sizes.nx; ++i)
      sizes.lane_distance_m.push_back(distance_to_lanes(
          sizes.corner + sizes.spacing_m * Eigen::Vector2i(i, j).cast<float>(), scene.lanes));
  return sizes;
}

}  // namespace cps
