#include <algorithm>
#include <cmath>

#include "scenes/city/buildings/building.h"
#include "scenes/city/buildings/curtain_wall.h"
#include "scenes/city/buildings/opening.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

struct Podium {
  std::vector<double> floors;
  double eaves = 0;
};

Podium draw_podium(int storeys, Draws& draws) {
  Podium p;
  double z = kerb_height_m;
  for (int k = 0; k < storeys; ++k) {
    p.floors.push_back(z);
    z += k == 0 ? draws.uniform(4.2, 5.2) : 3.6;
  }
  p.eaves = z;
  return p;
}

FacadeStyle draw_podium_style(const Materials& m, Draws& draws) {
  FacadeStyle s;
  const double wall = draws.uniform(0, 1);
  s.wall = wall < 0.35 ? m.stone : wall < 0.65 ? draws.one_of(m.concrete) : draws.one_of(m.plaster);
  s.ground_wall = s.wall;
  s.frame = draws.chance(0.7) ? m.frame_dark : m.frame_white;
  s.bay_m = draws.uniform(3.2, 5.2);
  s.window_width_m = s.bay_m * draws.uniform(0.6, 0.85);
  s.window_height_m = draws.uniform(2.0, 2.5);
  s.sill_m = draws.uniform(0.3, 0.8);
  s.reveal_m = draws.uniform(0.15, 0.35);
  s.mullions = draws.integer(1, 3);
  s.shutter_share = 0;
  s.curtain_share = 0.15;
  return s;
}

void add_podium(Building& result, const Footprint& f, const Podium& podium, const FacadeStyle& style,
                const Materials& m, Draws& draws) {
  const Polygon ring = f.polygon();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Wall wall{ring[i],       ring[(i + 1) % ring.size()],
                    kerb_height_m, podium.eaves + parapet_m,
                    podium.floors, podium.eaves};
    const GroundFloor ground = i == 2 ? GroundFloor::windows : GroundFloor::shop;  // the rear has no shop
    const std::optional<Doorway> doorway = add_facade(result.mesh, wall, style, ground, i != 2, m, draws);
    if (doorway) result.doorways.push_back(*doorway);
  }
}

/// Adds a part of the tower's shaft, walls and roof; returns the height of its roof.
double add_shaft(Mesh& mesh, const Footprint& f, double bottom, int storeys, const CurtainStyle& style,
                 const Materials& m, Draws& draws) {
  const Polygon ring = f.polygon();
  const double top = bottom + storeys * style.storey_m;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
    add_curtain_wall(mesh, from, to, bottom, storeys, style);
    const WallFrame frame = make_wall_frame(from, to);
    const double out = style.band_depth_m;
    add_bar(mesh.surfaces[style.solid.material], frame,
            {0, (to - from).norm() + out, top - 0.1, top + parapet_m}, 0, out, style.solid.tile_m);
  }
  RoofPlan roof;
  roof.kind = RoofKind::flat;
  roof.wall = style.solid;
  add_roof(mesh, f, top, roof, m, draws);
  return top;
}

/// The footprint inset on all sides; its width and depth are whole numbers of glass panels.
Footprint drawn_in(const Footprint& f, double front_m, double sides_m, double back_m) {
  const Vec2 along = (f.front[1] - f.front[0]).normalized(), in = left_of(along);
  const double full = (f.front[1] - f.front[0]).norm(), room = full - 2 * sides_m;
  const double width = std::floor(room / curtain_panel_m) * curtain_panel_m;
  const double deep = std::floor((f.depth_m - front_m - back_m) / curtain_panel_m) * curtain_panel_m;
  const Vec2 start = f.front[0] + along * ((full - width) / 2) + in * front_m;
  return make_footprint({start, start + along * width}, deep);
}

/// Adds a plant room on the roof, sometimes with a mast.
void add_crown(Mesh& mesh, const Footprint& f, double top, const CurtainStyle& style, const Materials& m,
               Draws& draws) {
  const Vec2 along = (f.front[1] - f.front[0]).normalized();
  const Vec2 middle = (f.at(0, f.depth_m / 2) + f.at(1, f.depth_m / 2)) / 2;
  const double width = (f.front[1] - f.front[0]).norm();
  const double height = draws.uniform(2.5, 5);
  add_box(mesh.surfaces[draws.chance(0.5) ? style.solid.material : m.roof_metal], middle, along,
          width * draws.uniform(0.2, 0.35), f.depth_m * draws.uniform(0.2, 0.35), top, top + height, 3);
  if (draws.chance(0.25))
    add_tube(mesh.surfaces[m.pole], lift(middle, top + height),
             lift(middle, top + height + draws.uniform(6, 18)), 0.25, 0.05, 8, true);
}

}  // namespace

Building tower(const BuildingPlan& plan, const Materials& m, Stream stream) {
  Building result;
  Mesh& mesh = result.mesh;
  Draws draws{stream}, openings{substream(stream, 1)}, details{substream(stream, 2)};
  const Footprint& f = plan.footprint;
  const Podium podium = draw_podium(draws.integer(1, std::min(4, std::max(1, plan.storeys / 4))), draws);
  const FacadeStyle style = draw_podium_style(m, draws);
  const CurtainStyle curtain = draw_curtain_style(m, draws);
  add_podium(result, f, podium, style, m, openings);
  RoofPlan deck;
  deck.kind = RoofKind::flat;
  deck.wall = style.wall;
  add_roof(mesh, f, podium.eaves, deck, m, details);

  const int storeys = plan.storeys - static_cast<int>(podium.floors.size());
  Footprint shaft = drawn_in(f, draws.chance(0.5) ? 0.9 : draws.uniform(1.5, 5), draws.uniform(0.9, 4),
                             draws.uniform(0.9, 4));
  const bool tiered = storeys > 12 && draws.chance(0.45);
  const int lower = tiered ? static_cast<int>(storeys * draws.uniform(0.5, 0.8)) : storeys;
  double top = add_shaft(mesh, shaft, podium.eaves, lower, curtain, m, details);
  if (tiered) {
    const double step = 0.08 * std::min(shaft.depth_m, (shaft.front[1] - shaft.front[0]).norm());
    shaft =
        drawn_in(shaft, step * draws.uniform(1, 2), step * draws.uniform(1, 2), step * draws.uniform(1, 2));
    top = add_shaft(mesh, shaft, top, storeys - lower, curtain, m, details);
  }
  add_crown(mesh, shaft, top, curtain, m, details);
  return result;
}

}  // namespace cps::city
