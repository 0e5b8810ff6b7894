#include "scenes/city/buildings/foundation.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/buildings/opening.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

constexpr double buried_m = 0.3;  ///< depth of foundations below the ground
constexpr double max_step_m = 0.17, tread_m = 0.3, landing_m = 0.6, ramp_m = 3;

double lowest_along(const Vec2& from, const Vec2& to, const Terrain& terrain) {
  double lowest = terrain.height_m(to);
  for (const Vec2& p : subdivided({from, to}, max_road_edge_m))
    lowest = std::min(lowest, terrain.height_m(p));
  return lowest;
}

void add_walls_below(Surface& surface, const Polygon& ring, double tile_m, double level_m,
                     const Terrain& terrain) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
    const double bottom = lowest_along(from, to, terrain) - level_m - buried_m;
    if ((to - from).norm() > 1e-3 && bottom < 0)
      add_panel(surface, make_wall_frame(from, to),
                {0, (to - from).norm(), kerb_height_m + bottom, kerb_height_m}, 0, tile_m);
  }
}

/// The frame of a doorway: u along the wall from the doorway's middle, w outwards.
WallFrame frame_of(const Doorway& doorway) {
  return {doorway.middle, left_of(doorway.out), doorway.out};
}

void add_steps(Surface& surface, const Doorway& doorway, double drop_m, double tile_m) {
  const int steps = static_cast<int>(std::ceil(drop_m / max_step_m));
  const double half = doorway.width_m / 2 + 0.25, bottom = kerb_height_m - drop_m - buried_m;
  double from = 0, to = landing_m;
  for (int k = 0; k < steps; ++k) {
    add_bar(surface, frame_of(doorway), {-half, half, bottom, kerb_height_m - drop_m * k / steps}, from, to,
            tile_m, left_face | right_face | upper_face);
    from = to;
    to += tread_m;
  }
}

void add_ramp(Surface& surface, const Doorway& doorway, double drop_m, double tile_m) {
  const WallFrame f = frame_of(doorway);
  const double half = doorway.width_m / 2, top = kerb_height_m + 0.005, bottom = top - drop_m - 0.05;
  const auto corner = [&](double u, double z, double w) {
    return Vertex{f.point(u, z, w), Vec2(u, -w) / tile_m};
  };
  add_quad(surface, corner(-half, bottom, ramp_m), corner(half, bottom, ramp_m), corner(half, top, 0),
           corner(-half, top, 0));
  for (const double side : {-1.0, 1.0}) {
    const Vertex a{f.point(side * half, top, 0), {0, -top / tile_m}},
        b{f.point(side * half, bottom, 0), {0, -bottom / tile_m}},
        c{f.point(side * half, bottom, ramp_m), {ramp_m / tile_m, -bottom / tile_m}};
    side < 0 ? add_polygon(surface, {a, b, c}) : add_polygon(surface, {a, c, b});
  }
}

}  // namespace

double ground_level_m(const Building& building, const BuildingPlan& plan, const Terrain& terrain) {
  const Footprint& f = plan.footprint;
  if (building.doorways.empty())
    return terrain.height_m((f.at(0, f.depth_m / 2) + f.at(1, f.depth_m / 2)) / 2);
  double highest = terrain.height_m(building.doorways[0].middle);
  for (const Doorway& d : building.doorways) highest = std::max(highest, terrain.height_m(d.middle));
  return highest;
}

void add_foundation(Building& building, const BuildingPlan& plan, double level_m, const Terrain& terrain,
                    const Materials& m) {
  if (terrain.waves.empty()) return;
  const bool is_works = plan.kind == BuildingKind::hall || plan.kind == BuildingKind::garage;
  const WallMaterial cover = is_works ? m.concrete[0] : m.stone;
  Surface& surface = building.mesh.surfaces[cover.material];
  add_walls_below(surface, plan.footprint.polygon(), cover.tile_m, level_m, terrain);
  if (const Polygon wing = rear_wing(plan); !wing.empty())
    add_walls_below(surface, wing, cover.tile_m, level_m, terrain);
  for (const Doorway& d : building.doorways) {
    if (level_m - terrain.height_m(d.middle) < 0.04) continue;
    const double reach_m = d.is_gate ? ramp_m : landing_m;
    const double drop_m = level_m - terrain.height_m(d.middle + d.out * reach_m);
    if (drop_m < 0.04) continue;
    if (d.is_gate)
      add_ramp(surface, d, drop_m, cover.tile_m);
    else
      add_steps(surface, d, drop_m, cover.tile_m);
  }
}

}  // namespace cps::city
