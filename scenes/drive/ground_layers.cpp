#include "scenes/drive/ground_layers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scenes/enclosures.h"

namespace cps {
namespace {

constexpr int max_columns_per_side = 700;
constexpr int max_hits = 12;  ///< surfaces examined in one column
constexpr double headroom_m = 2.2;
constexpr float cos_max_slope = 0.9063f;  // 25°
constexpr double tan_max_slope = 0.4663, max_step_m = 0.2;
constexpr double bumper_m = 0.45;

/// The part of the scene to search: all of it, or of a scene that is too large for the grid, what lies around
/// the place with the most vertices.
Eigen::AlignedBox3d search_window(const Scene& scene) {
  constexpr double max_cell_m = 1, side_m = max_cell_m * max_columns_per_side;
  constexpr int blocks = 128;
  const Eigen::AlignedBox3d whole = bounds_without_enclosures(scene).cast<double>();
  const Eigen::Vector3d size = whole.sizes();
  if (std::max(size.x(), size.z()) <= side_m) return whole;
  std::vector<std::int64_t> vertices(blocks * blocks, 0);
  const auto block_of = [&](double share) {
    return std::clamp(static_cast<int>(share * blocks), 0, blocks - 1);
  };
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (mesh.is_enclosure) continue;
    for (const Eigen::Vector3f& position : mesh.positions) {
      const Eigen::Vector3d at = (instance.world_from_mesh * position).cast<double>() - whole.min();
      ++vertices[block_of(at.z() / size.z()) * blocks + block_of(at.x() / size.x())];
    }
  }
  const auto fullest = std::max_element(vertices.begin(), vertices.end()) - vertices.begin();
  const Eigen::Vector3d middle =
      whole.min() + Eigen::Vector3d((fullest % blocks + 0.5) * size.x() / blocks, 0,
                                    (fullest / blocks + 0.5) * size.z() / blocks);
  Eigen::AlignedBox3d window = whole;
  for (int axis : {0, 2}) {
    window.min()[axis] = std::max(window.min()[axis], middle[axis] - side_m / 2);
    window.max()[axis] = std::min(window.max()[axis], middle[axis] + side_m / 2);
  }
  return window;
}

/// Adds the drivable surfaces below a point above the scene, the lowest first.
void add_surfaces(GroundLayers& layers, const SceneRays& rays, const Eigen::Vector3f& above) {
  const std::size_t begin = layers.surfaces.size();
  double fallen_m = 0, ceiling_m = -1e9;
  for (int layer = 0; layer < max_hits; ++layer) {
    const Eigen::Vector3f from = above - Eigen::Vector3f(0, static_cast<float>(fallen_m), 0);
    const auto hit = first_hit(rays, from, {0, -1, 0});
    if (!hit) break;
    const double at_m = fallen_m + hit->distance_m;
    const bool is_flat = !hit->shows_back && std::abs(hit->normal.y()) > cos_max_slope;
    if (is_flat && at_m - ceiling_m >= headroom_m) {
      layers.surfaces.emplace_back(above.x(), static_cast<float>(above.y() - at_m), above.z());
      layers.is_open.push_back(layer == 0);
    }
    ceiling_m = at_m;
    fallen_m = at_m + 0.01;
  }
  const auto from = static_cast<std::ptrdiff_t>(begin);
  std::reverse(layers.surfaces.begin() + from, layers.surfaces.end());
  std::reverse(layers.is_open.begin() + from, layers.is_open.end());
}

bool is_passable(const SceneRays& rays, const Eigen::Vector3f& a, const Eigen::Vector3f& b, double cell_m) {
  if (std::abs(a.y() - b.y()) > std::max(max_step_m, tan_max_slope * cell_m)) return false;
  const float reach_m = (b - a).norm();
  const Eigen::Vector3f direction = (b - a) / reach_m;
  for (const double height_m : {bumper_m, bonnet_m}) {
    const Eigen::Vector3f up(0, static_cast<float>(height_m), 0);
    if (const auto hit = first_hit(rays, a + up, direction); hit && hit->distance_m < reach_m) return false;
    // And backwards: a ray may pass through a single-sided wall from behind.
    if (const auto hit = first_hit(rays, b + up, -direction); hit && hit->distance_m < reach_m) return false;
  }
  return true;
}

/// The surface of column `to` that a car can drive to from surface `from`; −1 if there is none.
int way_to(const GroundLayers& layers, const SceneRays& rays, int from, int to) {
  for (int surface = layers.first[to]; surface < layers.first[to + 1]; ++surface)
    if (is_passable(rays, layers.surfaces[from], layers.surfaces[surface], layers.cell_m)) return surface;
  return -1;
}

/// Numbers the connected pieces (union-find with halving).
void number_pieces(GroundLayers& layers) {
  std::vector<int> parent(layers.surfaces.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int surface) {
    while (parent[surface] != surface) surface = parent[surface] = parent[parent[surface]];
    return surface;
  };
  for (std::size_t i = 0; i < parent.size(); ++i)
    for (const int next : {layers.east[i], layers.south[i]}) {
      if (next < 0) continue;
      const auto [low, high] = std::minmax({root(static_cast<int>(i)), root(next)});
      parent[high] = low;
    }
  layers.piece.assign(parent.size(), -1);
  for (std::size_t i = 0; i < parent.size(); ++i) {
    const int first = root(static_cast<int>(i));
    layers.piece[i] = first == static_cast<int>(i) ? layers.pieces++ : layers.piece[first];
  }
}

}  // namespace

GroundLayers ground_layers(const Scene& scene, const SceneRays& rays) {
  GroundLayers layers;
  const Eigen::AlignedBox3d window = search_window(scene);
  const Eigen::Vector3d low = window.min(), size = window.sizes();
  layers.cell_m = std::max(0.5, std::max(size.x(), size.z()) / max_columns_per_side);
  layers.corner = Eigen::Vector2d(low.x(), low.z());
  layers.nx = static_cast<int>(size.x() / layers.cell_m) + 1;
  layers.nz = static_cast<int>(size.z() / layers.cell_m) + 1;
  const auto top = static_cast<float>(window.max().y() + 1);
  for (int z = 0; z < layers.nz; ++z)
    for (int x = 0; x < layers.nx; ++x) {
      const Eigen::Vector2d at = layers.corner + layers.cell_m * Eigen::Vector2d(x, z);
      layers.first.push_back(static_cast<int>(layers.surfaces.size()));
      add_surfaces(layers, rays, {static_cast<float>(at.x()), top, static_cast<float>(at.y())});
    }
  layers.first.push_back(static_cast<int>(layers.surfaces.size()));
  layers.east.assign(layers.surfaces.size(), -1);
  layers.south.assign(layers.surfaces.size(), -1);
  layers.around.assign(layers.surfaces.size(), {});
  for (int z = 0; z < layers.nz; ++z)
    for (int x = 0; x < layers.nx; ++x) {
      const int column = z * layers.nx + x;
      for (int i = layers.first[column]; i < layers.first[column + 1]; ++i) {
        if (x + 1 < layers.nx) layers.east[i] = way_to(layers, rays, i, column + 1);
        if (z + 1 < layers.nz) layers.south[i] = way_to(layers, rays, i, column + layers.nx);
        if (x % sample_stride == 0 && z % sample_stride == 0)
          layers.around[i] = look_around(rays, layers.surfaces[i]);
      }
    }
  number_pieces(layers);
  return layers;
}

}  // namespace cps
