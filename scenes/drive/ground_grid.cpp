#include "scenes/drive/ground_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/drive/street_piece.h"

namespace cps {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// Calls visit(neighbour) for the adjacent cells that a car can drive to.
template <typename Visitor>
void for_each_way(const GroundGrid& grid, int cell, Visitor&& visit) {
  const int x = cell % grid.nx, z = cell / grid.nx;
  if (x + 1 < grid.nx && grid.east[cell]) visit(cell + 1);
  if (x > 0 && grid.east[cell - 1]) visit(cell - 1);
  if (z + 1 < grid.nz && grid.south[cell]) visit(cell + grid.nx);
  if (z > 0 && grid.south[cell - grid.nx]) visit(cell - grid.nx);
}

/// Fills `room_m`: the distance to the nearest cell that lacks a passable neighbour, by a two-pass chamfer
/// transform (Borgefors 1986).
void measure_room(GroundGrid& grid) {
  const auto side = static_cast<float>(grid.cell_m), diagonal = side * 1.41421356f;
  grid.room_m.assign(grid.nx * grid.nz, 0);
  for (int z = 1; z + 1 < grid.nz; ++z)
    for (int x = 1; x + 1 < grid.nx; ++x) {
      int ways = 0;
      for_each_way(grid, grid.index(x, z), [&](int) { ++ways; });
      if (ways == 4) grid.room_m[grid.index(x, z)] = 1e9f;
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

Surroundings GroundGrid::around_at(const Eigen::Vector2d& point) const {
  const int cell = cell_at(point);
  return cell < 0 ? Surroundings{} : around[cell];
}

Eigen::Vector3d GroundGrid::ground_at(const Eigen::Vector2d& point) const {
  const int cell = cell_at(point);
  return {point.x(), cell < 0 ? 0 : height[cell], point.y()};
}

GroundGrid ground_grid(const Scene& scene, const SceneRays& rays) {
  const GroundLayers layers = ground_layers(scene, rays);
  const StreetPiece street = street_piece(layers, rays);
  GroundGrid grid;
  grid.cell_m = layers.cell_m;
  grid.corner = layers.corner;
  grid.nx = layers.nx;
  grid.nz = layers.nz;
  grid.rivals = street.rivals;
  const int cells = grid.nx * grid.nz;
  grid.height.assign(cells, none);
  grid.east.assign(cells, 0);
  grid.south.assign(cells, 0);
  grid.around.assign(cells, {});
  std::vector<int> surface(cells, -1);  // where the piece passes over itself, the lowest
  for (int cell = 0; cell < cells; ++cell)
    for (int i = layers.first[cell]; i < layers.first[cell + 1] && surface[cell] < 0; ++i)
      if (layers.piece[i] == street.piece) surface[cell] = i;
  for (int cell = 0; cell < cells; ++cell) {
    if (surface[cell] < 0) continue;
    const int i = surface[cell];
    grid.height[cell] = layers.surfaces[i].y();
    grid.east[cell] = layers.east[i] >= 0 && layers.east[i] == surface[cell + 1];
    grid.south[cell] = layers.south[i] >= 0 && layers.south[i] == surface[cell + grid.nx];
    grid.area_m2 += grid.cell_m * grid.cell_m;
    grid.level_m += grid.height[cell];
  }
  if (grid.area_m2 > 0) grid.level_m /= grid.area_m2 / (grid.cell_m * grid.cell_m);
  for (int z = 0; z < grid.nz; ++z)
    for (int x = 0; x < grid.nx; ++x) {
      // A block of cells shares the look from its sample column, if the street has one there.
      const int cell = grid.index(x, z),
                sample = grid.index(x / sample_stride * sample_stride, z / sample_stride * sample_stride);
      if (surface[cell] < 0) continue;
      grid.around[cell] = surface[sample] >= 0 ? layers.around[surface[sample]]
                                               : look_around(rays, layers.surfaces[surface[cell]]);
    }
  measure_room(grid);
  return grid;
}

}  // namespace cps
