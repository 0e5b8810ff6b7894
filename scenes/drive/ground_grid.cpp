#include "scenes/drive/ground_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cps {
namespace {

constexpr int max_cells_per_side = 700;
constexpr int max_layers = 12;  ///< surfaces examined below one point
constexpr double headroom_m = 2.2;
constexpr float cos_max_slope = 0.9063f;  // 25°
constexpr double tan_max_slope = 0.4663, step_m = 0.2;
constexpr double bumper_m = 0.45, bonnet_m = 1.1;
constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// The height of the lowest drivable surface below a point above the scene; NaN if there is none.
float lowest_ground(const SceneRays& rays, const Eigen::Vector3f& above) {
  float ground = none;
  double fallen_m = 0, ceiling_m = -1e9;
  for (int layer = 0; layer < max_layers; ++layer) {
    const Eigen::Vector3f from = above - Eigen::Vector3f(0, static_cast<float>(fallen_m), 0);
    const auto hit = first_hit(rays, from, {0, -1, 0});
    if (!hit) break;
    const double at_m = fallen_m + hit->distance_m;
    const bool is_flat = !hit->shows_back && std::abs(hit->normal.y()) > cos_max_slope;
    if (is_flat && at_m - ceiling_m >= headroom_m) ground = static_cast<float>(above.y() - at_m);
    ceiling_m = at_m;
    fallen_m = at_m + 0.01;
  }
  return ground;
}

bool is_passable(const SceneRays& rays, const Eigen::Vector3f& a, const Eigen::Vector3f& b, double cell_m) {
  if (std::isnan(a.y()) || std::isnan(b.y())) return false;
  if (std::abs(a.y() - b.y()) > std::max(step_m, tan_max_slope * cell_m)) return false;
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

/// Calls visit(neighbour) for the adjacent cells that a car can drive to.
template <typename Visitor>
void for_each_way(const GroundGrid& grid, int cell, Visitor&& visit) {
  const int x = cell % grid.nx, z = cell / grid.nx;
  if (x + 1 < grid.nx && grid.east[cell]) visit(cell + 1);
  if (x > 0 && grid.east[cell - 1]) visit(cell - 1);
  if (z + 1 < grid.nz && grid.south[cell]) visit(cell + grid.nx);
  if (z > 0 && grid.south[cell - grid.nx]) visit(cell - grid.nx);
}

/// Marks the cells of the largest connected piece.
std::vector<std::uint8_t> largest_piece(const GroundGrid& grid) {
  const int cells = grid.nx * grid.nz;
  std::vector<int> piece(cells, -1);
  int best = -1, best_size = 0, pieces = 0;
  std::vector<int> open;
  for (int first = 0; first < cells; ++first) {
    if (piece[first] >= 0 || std::isnan(grid.height[first])) continue;
    int size = 0;
    piece[first] = pieces;
    open = {first};
    while (!open.empty()) {
      const int cell = open.back();
      open.pop_back();
      ++size;
      for_each_way(grid, cell, [&](int next) {
        if (piece[next] >= 0) return;
        piece[next] = pieces;
        open.push_back(next);
      });
    }
    if (size > best_size) best = pieces, best_size = size;
    ++pieces;
  }
  std::vector<std::uint8_t> in_largest(cells);
  for (int cell = 0; cell < cells; ++cell) in_largest[cell] = best >= 0 && piece[cell] == best;
  return in_largest;
}

/// Fills `room_m`: the distance to the nearest cell that lacks a passable neighbour, by a two-pass chamfer
/// transform (Borgefors 1986).
void measure_room(GroundGrid& grid, const std::vector<std::uint8_t>& in_piece) {
  const auto side = static_cast<float>(grid.cell_m), diagonal = side * 1.41421356f;
  grid.room_m.assign(grid.nx * grid.nz, 0);
  for (int z = 1; z + 1 < grid.nz; ++z)
    for (int x = 1; x + 1 < grid.nx; ++x) {
      int ways = 0;
      for_each_way(grid, grid.index(x, z), [&](int) { ++ways; });
      if (in_piece[grid.index(x, z)] && ways == 4) grid.room_m[grid.index(x, z)] = 1e9f;
    }
  const auto relax = [&](int x, int z, int sign) {
    float& room = grid.room_m[grid.index(x, z)];
    const auto from = [&](int dx, int dz, float step) {
      room = std::min(room, grid.room_m[grid.index(x + sign * dx, z + sign * dz)] + step);
    };
    from(-1, 0, side), from(0, -1, side), from(-1, -1, diagonal), from(1, -1, diagonal);
  };
  for (int z = 1; z + 1 < grid.nz; ++z)
    for (int x = 1; x + 1 < grid.nx; ++x) relax(x, z, 1);
  for (int z = grid.nz - 2; z > 0; --z)
    for (int x = grid.nx - 2; x > 0; --x) relax(x, z, -1);
}

}  // namespace

int GroundGrid::cell_at(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d at = (point - corner) / cell_m;
  const double x = std::round(at.x()), z = std::round(at.y());
  if (!(x >= 0 && x < nx && z >= 0 && z < nz)) return -1;
  return index(static_cast<int>(x), static_cast<int>(z));
}

double GroundGrid::room_at(const Eigen::Vector2d& point) const {
  const int cell = cell_at(point);
  return cell < 0 ? 0 : room_m[cell];
}

Eigen::Vector3d GroundGrid::ground_at(const Eigen::Vector2d& point) const {
  const int cell = cell_at(point);
  return {point.x(), cell < 0 ? 0 : height[cell], point.y()};
}

GroundGrid ground_grid(const Scene& scene, const SceneRays& rays) {
  GroundGrid grid;
  const Eigen::Vector3d low = scene.bounds.min().cast<double>(), size = scene.bounds.sizes().cast<double>();
  grid.cell_m = std::max(0.5, std::max(size.x(), size.z()) / max_cells_per_side);
  grid.corner = Eigen::Vector2d(low.x(), low.z());
  grid.nx = static_cast<int>(size.x() / grid.cell_m) + 1;
  grid.nz = static_cast<int>(size.z() / grid.cell_m) + 1;
  const int cells = grid.nx * grid.nz;
  const auto top = static_cast<float>(scene.bounds.max().y() + 1);
  std::vector<Eigen::Vector3f> ground(cells);
  grid.height.resize(cells);
  grid.east.assign(cells, 0);
  grid.south.assign(cells, 0);
  for (int z = 0; z < grid.nz; ++z)
    for (int x = 0; x < grid.nx; ++x) {
      const Eigen::Vector2d at = grid.corner + grid.cell_m * Eigen::Vector2d(x, z);
      const Eigen::Vector3f above(static_cast<float>(at.x()), top, static_cast<float>(at.y()));
      const int cell = grid.index(x, z);
      grid.height[cell] = lowest_ground(rays, above);
      ground[cell] = {above.x(), grid.height[cell], above.z()};
    }
  for (int z = 0; z < grid.nz; ++z)
    for (int x = 0; x < grid.nx; ++x) {
      const int cell = grid.index(x, z);
      if (x + 1 < grid.nx) grid.east[cell] = is_passable(rays, ground[cell], ground[cell + 1], grid.cell_m);
      if (z + 1 < grid.nz)
        grid.south[cell] = is_passable(rays, ground[cell], ground[cell + grid.nx], grid.cell_m);
    }
  const std::vector<std::uint8_t> in_piece = largest_piece(grid);
  measure_room(grid, in_piece);
  grid.area_m2 = std::count(in_piece.begin(), in_piece.end(), 1) * grid.cell_m * grid.cell_m;
  return grid;
}

}  // namespace cps
