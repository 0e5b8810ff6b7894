#include "scenes/city/buildings/facade.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/buildings/opening.h"

namespace cps::city {
namespace {

constexpr double near_street_m = 8;
constexpr double door_width_m = 1.15, door_height_m = 2.5;  // including the window above the leaf

std::vector<Opening> upper_storey(double width, int bays, double floor, double ceiling,
                                  const FacadeStyle& style) {
  std::vector<Opening> openings;
  const double bay = width / bays, window = std::min(style.window_width_m, bay - 0.3);
  const double bottom = floor + style.sill_m, top = std::min(bottom + style.window_height_m, ceiling - 0.25);
  for (int b = 0; b < bays; ++b) {
    const double middle = (b + 0.5) * bay;
    openings.push_back({Opening::Kind::window, middle - window / 2, middle + window / 2, bottom, top});
  }
  return openings;
}

std::vector<Opening> ground_storey(double width, int bays, double floor, double ceiling,
                                   const FacadeStyle& style, GroundFloor kind, Draws& draws) {
  std::vector<Opening> openings = upper_storey(width, bays, floor, ceiling, style);
  if (kind == GroundFloor::windows) return openings;
  const int door_bay = draws.integer(0, bays - 1);
  const double bay = width / bays;
  for (int b = 0; b < bays; ++b) {
    const double middle = (b + 0.5) * bay;
    if (b == door_bay) {
      openings[b] = {Opening::Kind::door, middle - door_width_m / 2, middle + door_width_m / 2, floor + 0.1,
                     std::min(floor + 0.1 + door_height_m, ceiling - 0.2)};
    } else if (kind == GroundFloor::shop) {
      const double half = (bay - 0.45) / 2;
      openings[b] = {Opening::Kind::shop, middle - half, middle + half, floor + 0.1,
                     std::min(floor + 3.0, ceiling - 0.65)};
    }
  }
  return openings;
}

void add_shop_sign(Mesh& mesh, const WallFrame& frame, double width, double ceiling, const Materials& m,
                   Draws& draws) {
  const MaterialId color = draws.one_of(m.shop_sign);
  add_bar(mesh.surfaces[color], frame, {0.25, width - 0.25, ceiling - 0.6, ceiling - 0.08}, 0, 0.09);
  if (!draws.chance(0.4)) return;
  // An extended awning over the pavement.
  const double out = draws.uniform(0.9, 1.4), top = ceiling - 0.65, front = top - 0.55;
  Surface& cloth = mesh.surfaces[m.awning];
  const auto quad = [&](double u0, double u1, double z0, double w0, double z1, double w1) {
    add_quad(cloth, {frame.point(u0, z0, w0)}, {frame.point(u1, z0, w0)}, {frame.point(u1, z1, w1)},
             {frame.point(u0, z1, w1)});
  };
  quad(0.3, width - 0.3, front, out, top, 0.02);
  quad(width - 0.3, 0.3, front, out, top, 0.02);  // the underside
  quad(0.3, width - 0.3, front - 0.2, out, front, out);
  quad(width - 0.3, 0.3, front - 0.2, out, front, out);
}

/// Adds a balcony, a slab with a railing, in front of a window.
void add_balcony(Mesh& mesh, const WallFrame& frame, const Opening& window, double floor,
                 const Materials& m) {
  constexpr double out = 1.15, railing = 1.0;
  const double u0 = window.u0 - 0.45, u1 = window.u1 + 0.45;
  add_bar(mesh.surfaces[m.concrete[0].material], frame, {u0, u1, floor - 0.16, floor}, 0, out, 3);
  Surface& bars = mesh.surfaces[m.pole];
  add_bar(bars, frame, {u0, u1, floor + railing - 0.05, floor + railing}, out - 0.06, out - 0.01);
  for (const double u : {u0, u1 - 0.04})
    add_bar(bars, frame, {u, u + 0.04, floor + railing - 0.05, floor + railing}, 0, out - 0.01);
  const int posts = static_cast<int>((u1 - u0) / 0.18);
  for (int i = 0; i <= posts; ++i) {
    const double u = u0 + (u1 - u0 - 0.025) * i / posts;
    add_bar(bars, frame, {u, u + 0.025, floor, floor + railing - 0.05}, out - 0.05, out - 0.025, 1,
            left_face | right_face);
  }
}

}  // namespace

std::optional<Doorway> add_facade(Mesh& mesh, const Wall& wall, const FacadeStyle& style,
                                  GroundFloor ground_floor, bool on_street, const Materials& materials,
                                  Draws& draws) {
  const double width = (wall.to - wall.from).norm();
  const int bays = static_cast<int>((width - 0.6) / style.bay_m);
  if (bays < 1) {
    add_blank_wall(mesh, wall, style.wall);
    return std::nullopt;
  }
  std::optional<Doorway> doorway;
  const WallFrame frame = make_wall_frame(wall.from, wall.to);
  for (std::size_t k = 0; k < wall.floors.size(); ++k) {
    const double floor = wall.floors[k],
                 ceiling = k + 1 < wall.floors.size() ? wall.floors[k + 1] : wall.eaves;
    const Detail detail = !on_street              ? Detail::plain
                          : floor < near_street_m ? Detail::near_street
                                                  : Detail::upper_storey;
    const WallMaterial& material = k == 0 ? style.ground_wall : style.wall;
    const std::vector<Opening> openings =
        k == 0 ? ground_storey(width, bays, floor, ceiling, style, ground_floor, draws)
               : upper_storey(width, bays, floor, ceiling, style);
    add_pierced_wall(mesh.surfaces[material.material], frame, width, floor, ceiling, openings,
                     material.tile_m);
    for (const Opening& o : openings) {
      add_opening(mesh, frame, o, style, material, detail, materials, draws);
      if (o.kind == Opening::Kind::door) doorway = doorway_of(frame, o);
    }
    for (std::size_t b = 1; style.balconies && k > 0 && b + 1 < openings.size(); b += 2)
      add_balcony(mesh, frame, openings[b], floor, materials);
    if (k == 0 && ground_floor == GroundFloor::shop)
      add_shop_sign(mesh, frame, width, ceiling, materials, draws);
  }
  if (wall.top > wall.eaves)
    add_panel(mesh.surfaces[style.wall.material], frame, {0, width, wall.eaves, wall.top}, 0,
              style.wall.tile_m);
  return doorway;
}

void add_blank_wall(Mesh& mesh, const Wall& wall, const WallMaterial& material) {
  const double width = (wall.to - wall.from).norm();
  if (width < 1e-3) return;
  add_panel(mesh.surfaces[material.material], make_wall_frame(wall.from, wall.to),
            {0, width, wall.bottom, wall.top}, 0, material.tile_m);
}

}  // namespace cps::city
