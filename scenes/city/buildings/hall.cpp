#include <algorithm>
#include <cmath>

#include "scenes/city/buildings/building.h"
#include "scenes/city/buildings/opening.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

constexpr double gate_height_m = 4.2, gate_width_m = 4.0, door_width_m = 1.15, door_height_m = 2.5;

struct HallStyle {
  WallMaterial wall;
  FacadeStyle openings;
  MaterialId gate = 0, trim = 0;
  double eaves = 7, plinth_m = 0.5;
  bool strip_windows = true;
};

HallStyle draw_style(const Materials& m, Draws& draws) {
  HallStyle s;
  const double kind = draws.uniform(0, 1);
  s.wall = kind < 0.6 ? draws.one_of(m.sheet) : kind < 0.8 ? draws.one_of(m.concrete) : draws.one_of(m.brick);
  s.openings.wall = s.openings.ground_wall = s.wall;
  s.openings.frame = draws.chance(0.5) ? m.frame_dark : m.frame_white;
  s.openings.reveal_m = 0.1;
  s.openings.mullions = 3;
  s.openings.shutter_share = 0;
  s.openings.curtain_share = 0.3;
  s.gate = draws.one_of(m.gate);
  s.trim = draws.chance(0.5) ? m.roof_metal : draws.one_of(m.gate);
  s.eaves = kerb_height_m + draws.uniform(5.8, 10.5);
  s.plinth_m = draws.uniform(0.3, 1.1);
  s.strip_windows = draws.chance(0.75);
  return s;
}

/// Gates and one door in bays of equal width.
std::vector<Opening> ground_openings(double width, bool with_gates, Draws& draws) {
  std::vector<Opening> openings;
  const double floor = kerb_height_m;
  const int bays = static_cast<int>((width - 1) / (gate_width_m + 1.6));
  if (bays < 1 || !with_gates) return openings;
  const int door_bay = draws.integer(0, bays - 1);
  const double bay = width / bays, share = draws.uniform(0.25, 0.9);
  for (int b = 0; b < bays; ++b) {
    const double middle = (b + 0.5) * bay;
    if (b == door_bay)
      openings.push_back({Opening::Kind::door, middle - door_width_m / 2, middle + door_width_m / 2,
                          floor + 0.1, floor + 0.1 + door_height_m});
    else if (draws.chance(share))
      openings.push_back({Opening::Kind::gate, middle - gate_width_m / 2, middle + gate_width_m / 2, floor,
                          floor + gate_height_m});
  }
  return openings;
}

std::vector<Opening> strip_openings(double width, double bottom, double top) {
  std::vector<Opening> openings;
  const int bays = std::max(1, static_cast<int>(width / 6));
  const double bay = width / bays;
  for (int b = 0; b < bays; ++b)
    openings.push_back({Opening::Kind::window, b * bay + 0.35, (b + 1) * bay - 0.35, bottom, top});
  return openings;
}

void add_hall_wall(Building& result, const Vec2& from, const Vec2& to, const HallStyle& s, double top,
                   bool with_gates, const Materials& m, Draws& draws) {
  Mesh& mesh = result.mesh;
  const WallFrame frame = make_wall_frame(from, to);
  const double width = (to - from).norm(), band = kerb_height_m + gate_height_m + 0.4;
  Surface& wall = mesh.surfaces[s.wall.material];
  const std::vector<Opening> ground = ground_openings(width, with_gates, draws);
  add_pierced_wall(wall, frame, width, kerb_height_m, band, ground, s.wall.tile_m);
  double u = 0;  // the plinth runs between the gates
  Surface& plinth = mesh.surfaces[m.concrete[0].material];
  for (const Opening& o : ground) {
    result.doorways.push_back(doorway_of(frame, o));
    if (o.kind == Opening::Kind::gate)
      add_gate(mesh, frame, o, s.gate, m);
    else
      add_opening(mesh, frame, o, s.openings, s.wall, Detail::near_street, m, draws);
    add_bar(plinth, frame, {u, o.u0 - 0.1, kerb_height_m, kerb_height_m + s.plinth_m}, 0, 0.05, 3);
    u = o.u1 + 0.1;
  }
  add_bar(plinth, frame, {u, width, kerb_height_m, kerb_height_m + s.plinth_m}, 0, 0.05, 3);
  std::vector<Opening> strip;
  if (s.strip_windows && s.eaves - band > 1.6)
    strip = strip_openings(width, band + 0.1, std::min(band + 1.3, s.eaves - 0.4));
  add_pierced_wall(wall, frame, width, band, top, strip, s.wall.tile_m);
  for (const Opening& o : strip)
    add_opening(mesh, frame, o, s.openings, s.wall, Detail::upper_storey, m, draws);
  add_bar(mesh.surfaces[s.trim], frame, {-0.05, width + 0.05, top - 0.35, top + 0.02}, 0, 0.06);
}

void add_company_sign(Mesh& mesh, const Vec2& from, const Vec2& to, const HallStyle& s, const Materials& m,
                      Draws& draws) {
  const double width = (to - from).norm(), sign = std::min(width * 0.5, draws.uniform(4, 10));
  const double u = draws.uniform(0.5, width - sign - 0.5), top = s.eaves - 0.5;
  if (top - 1.2 > kerb_height_m + gate_height_m + 0.2)
    add_bar(mesh.surfaces[draws.one_of(m.shop_sign)], make_wall_frame(from, to),
            {u, u + sign, top - draws.uniform(0.9, 1.2), top}, 0, 0.25);
}

}  // namespace

Building hall(const BuildingPlan& plan, const Materials& m, Stream stream) {
  Building result;
  Mesh& mesh = result.mesh;
  Draws draws{stream}, openings{substream(stream, 1)}, details{substream(stream, 2)};
  HallStyle style = draw_style(m, draws);
  const bool flat = plan.roof == RoofKind::flat;
  const Polygon ring = plan.footprint.polygon();
  for (std::size_t i = 0; i < ring.size(); ++i)
    add_hall_wall(result, ring[i], ring[(i + 1) % ring.size()], style, style.eaves + (flat ? parapet_m : 0),
                  i == 0 || openings.chance(0.3), m, openings);
  add_company_sign(mesh, ring[0], ring[1], style, m, draws);
  RoofPlan roof;
  roof.kind = plan.roof;
  roof.pitch_deg = draws.uniform(6, 16);
  roof.free_start = roof.free_end = true;
  roof.wall = style.wall;
  roof.cover = draws.one_of(m.sheet).material;
  roof.lived_under = false;
  add_roof(mesh, plan.footprint, style.eaves, roof, m, details);
  if (draws.chance(0.2)) {
    const Vec2 at = plan.footprint.at(0, plan.footprint.depth_m - 2) +
                    (plan.footprint.front[1] - plan.footprint.front[0]).normalized() * 2.5;
    add_tube(mesh.surfaces[draws.chance(0.5) ? m.brick[0].material : m.roof_metal], lift(at, style.eaves - 1),
             lift(at, style.eaves + draws.uniform(4, 14)), 0.7, 0.5, 16, true, brick_tile_m);
  }
  return result;
}

Building garage(const BuildingPlan& plan, const Materials& m, Stream stream) {
  Building result;
  Mesh& mesh = result.mesh;
  Draws draws{stream};
  const WallMaterial wall = draws.chance(0.8) ? draws.one_of(m.plaster) : draws.one_of(m.brick);
  const MaterialId leaf = draws.one_of(m.gate);
  const bool flat = plan.roof == RoofKind::flat;
  const double eaves = kerb_height_m + 2.6, top = eaves + (flat ? parapet_m : 0);
  const Polygon ring = plan.footprint.polygon();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const WallFrame frame = make_wall_frame(ring[i], ring[(i + 1) % ring.size()]);
    const double width = (ring[(i + 1) % ring.size()] - ring[i]).norm();
    std::vector<Opening> gates;
    const int count = i > 0 ? 0 : width > 5 ? 2 : 1;
    for (int k = 0; k < count; ++k) {
      const double middle = width * (k + 0.5) / count;
      gates.push_back({Opening::Kind::gate, middle - 1.2, middle + 1.2, kerb_height_m, kerb_height_m + 2.1});
    }
    add_pierced_wall(mesh.surfaces[wall.material], frame, width, kerb_height_m, top, gates, wall.tile_m);
    for (const Opening& o : gates) {
      add_gate(mesh, frame, o, leaf, m);
      result.doorways.push_back(doorway_of(frame, o));
    }
  }
  RoofPlan roof;
  roof.kind = plan.roof;
  roof.pitch_deg = draws.uniform(24, 38);
  roof.free_start = roof.free_end = true;
  roof.wall = wall;
  roof.cover = m.roof_tiles;
  roof.lived_under = false;
  add_roof(mesh, plan.gable_to_street ? turned(plan.footprint) : plan.footprint, eaves, roof, m, draws);
  return result;
}

}  // namespace cps::city
