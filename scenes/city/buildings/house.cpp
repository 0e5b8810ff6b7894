#include <algorithm>

#include "scenes/city/buildings/building.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

WallMaterial draw_wall(const BuildingPlan& plan, const Materials& m, Draws& draws) {
  const double kind = draws.uniform(0, 1);
  const bool tall = plan.storeys > 5;
  if (kind < (tall ? 0.35 : 0.66)) return draws.one_of(m.plaster);
  if (kind < (tall ? 0.5 : 0.92)) return draws.one_of(m.brick);
  return draws.one_of(m.concrete);
}

FacadeStyle draw_style(const BuildingPlan& plan, const Materials& m, Draws& draws) {
  FacadeStyle s;
  s.wall = draw_wall(plan, m, draws);
  s.ground_wall = draws.chance(plan.detached ? 0.15 : 0.4)
                      ? (draws.chance(0.6) ? m.stone : draws.one_of(m.brick))
                      : s.wall;
  const bool modern = plan.roof == RoofKind::flat && draws.chance(0.6);
  s.frame = draws.chance(modern ? 0.2 : 0.8) ? m.frame_white : m.frame_dark;
  if (modern) {
    s.bay_m = draws.uniform(2.8, 4.2);
    s.window_width_m = s.bay_m * draws.uniform(0.6, 0.9);
    s.window_height_m = draws.uniform(1.5, 2.1);
    s.sill_m = draws.uniform(0.35, 0.9);
    s.reveal_m = draws.uniform(0.1, 0.2);
    s.mullions = draws.integer(1, 3);
  } else {
    s.bay_m = draws.uniform(2.1, 3.2);
    s.window_width_m = draws.uniform(0.95, 1.3);
    s.window_height_m = draws.uniform(1.35, 1.9);
    s.sill_m = draws.uniform(0.8, 0.95);
    s.reveal_m = draws.uniform(0.12, 0.24);
    s.mullions = draws.chance(0.8) ? 1 : 0;
    s.transom = s.window_height_m > 1.6 && draws.chance(0.6);
    s.surrounds = draws.chance(0.45);
  }
  s.balconies = plan.storeys > 2 && !plan.shops && draws.chance(modern ? 0.5 : 0.12);
  s.shutter_share = draws.chance(0.4) ? draws.uniform(0.1, 0.5) : 0;
  s.curtain_share = draws.uniform(0.2, 0.5);
  return s;
}

struct Heights {
  std::vector<double> floors;
  double eaves = 0;
};

Heights draw_heights(const BuildingPlan& plan, Draws& draws) {
  Heights h;
  const double storey = draws.uniform(2.85, 3.3),
               ground = plan.shops ? draws.uniform(3.8, 4.3) : storey + 0.2;
  double z = kerb_height_m;
  for (int k = 0; k < plan.storeys; ++k) {
    h.floors.push_back(z);
    z += k == 0 ? ground : storey;
  }
  h.eaves = z;
  return h;
}

Wall make_wall(const Vec2& from, const Vec2& to, const Heights& h, double above_eaves) {
  return {from, to, kerb_height_m, h.eaves + above_eaves, h.floors, h.eaves};
}

/// Adds a string course above the ground floor, a cornice under the eaves and a drainpipe.
void add_mouldings(Mesh& mesh, const BuildingPlan& plan, const Heights& h, const Materials& m, Draws& draws) {
  Surface& stone = mesh.surfaces[m.stone.material];
  const auto band = [&](double bottom, double top, double out) {
    const std::vector<ProfilePoint> section{{0, bottom}, {-out, bottom}, {-out, top}, {0, top}};
    add_loft(stone, plan.footprint, section, m.stone.tile_m);
    add_loft_ends(stone, plan.footprint, section, m.stone.tile_m);
  };
  if (h.floors.size() > 1 && !plan.shops && draws.chance(0.5))
    band(h.floors[1] - 0.12, h.floors[1] + 0.08, 0.06);
  if (plan.roof == RoofKind::flat) {
    band(h.eaves + parapet_m - 0.12, h.eaves + parapet_m + 0.02, 0.06);
  } else {
    band(h.eaves - 0.22, h.eaves - 0.08, 0.08);
    if (plan.roof == RoofKind::mansard) band(h.eaves - 0.08, h.eaves + 0.1, 0.28);
  }
  const Vec2 start = plan.footprint.front.front(), along = (plan.footprint.front[1] - start).normalized();
  const Vec2 pipe = start + along * 0.12 - left_of(along) * 0.09;
  add_tube(mesh.surfaces[m.roof_metal], lift(pipe, kerb_height_m), lift(pipe, h.eaves - 0.1), 0.05, 0.05, 8);
}

void add_walls(Building& result, const BuildingPlan& plan, const Heights& h, const FacadeStyle& style,
               const Materials& m, Draws& draws) {
  Mesh& mesh = result.mesh;
  const Footprint& f = plan.footprint;
  const double above = plan.roof == RoofKind::flat ? parapet_m : 0;
  const std::size_t last = f.front.size() - 1;
  const std::size_t door_wall = last > 1 ? draws.integer(0, static_cast<int>(last) - 1) : 0;
  for (std::size_t i = 0; i < last; ++i) {
    const GroundFloor ground = plan.shops       ? GroundFloor::shop
                               : i == door_wall ? GroundFloor::entrance
                                                : GroundFloor::windows;
    const std::optional<Doorway> doorway = add_facade(mesh, make_wall(f.front[i], f.front[i + 1], h, above),
                                                      style, ground, !plan.distant, m, draws);
    if (doorway) result.doorways.push_back(*doorway);
  }
  FacadeStyle quiet = style;
  quiet.surrounds = quiet.balconies = false;
  quiet.bay_m *= 1.25;
  const Polyline back = f.line_at(f.depth_m);
  const auto add_side = [&](const Vec2& from, const Vec2& to, bool blank) {
    const Wall wall = make_wall(from, to, h, above);
    if (blank)
      add_blank_wall(mesh, wall, style.wall);
    else
      add_facade(mesh, wall, quiet, GroundFloor::windows, false, m, draws);
  };
  add_side(f.front[last], back[last], plan.party_end);
  for (std::size_t i = last; i > 0; --i) add_side(back[i], back[i - 1], false);
  add_side(back[0], f.front[0], plan.party_start);
}

}  // namespace

Building house(const BuildingPlan& plan, const Materials& m, Stream stream) {
  Building result;
  Mesh& mesh = result.mesh;
  Draws draws{stream};
  const Heights heights = draw_heights(plan, draws);
  const FacadeStyle style = draw_style(plan, m, draws);
  Draws openings{substream(stream, 1)}, details{substream(stream, 2)};
  add_walls(result, plan, heights, style, m, openings);
  add_mouldings(mesh, plan, heights, m, details);
  const RoofPlan roof{plan.roof,         draws.uniform(33, 48),
                      !plan.party_start, !plan.party_end,
                      style.wall,        !plan.distant && draws.chance(0.55),
                      m.roof_tiles};
  add_roof(mesh, plan.gable_to_street ? turned(plan.footprint) : plan.footprint, heights.eaves, roof, m,
           details);
  if (const Polygon wing = rear_wing(plan); !wing.empty()) {
    const int storeys = std::max(1, plan.storeys - 2);
    Heights low{{heights.floors.begin(), heights.floors.begin() + storeys}, 0};
    low.eaves = storeys < plan.storeys ? heights.floors[storeys] : heights.eaves;
    for (int i = 1; i < 4; ++i)  // its first side adjoins the house
      add_facade(mesh, make_wall(wing[i], wing[(i + 1) % 4], low, parapet_m), style, GroundFloor::windows,
                 false, m, openings);
    add_roof(mesh, make_footprint({wing[0], wing[1]}, plan.rear_wing_m), low.eaves - 0.01,
             {RoofKind::flat, 0, true, true, style.wall, false, m.roof_tiles}, m, details);
  }
  return result;
}

}  // namespace cps::city
