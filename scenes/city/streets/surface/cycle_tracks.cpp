#include "scenes/city/streets/surface/cycle_tracks.h"

#include <cmath>
#include <numbers>

#include "scenes/city/draws.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

constexpr double surface_height_m = 0.0045, stroke_m = 0.07;

}  // namespace

void paint_bicycle(Surface& paint, const Vec2& at, const Vec2& ahead, double height_m) {
  const Vec2 right = -left_of(ahead);
  const auto draw = [&](const std::vector<Vec2>& shape) {
    Polyline line;
    for (const Vec2& p : shape) line.push_back(at + right * p.x() + ahead * (1.7 * p.y()));
    add_stripe(paint, line, stroke_m, height_m, paint_tile_m);
  };
  const Vec2 rear(-0.33, 0.25), front(0.33, 0.25), pedals(-0.04, 0.27), seat(-0.14, 0.68), head(0.2, 0.68);
  for (const Vec2& hub : {rear, front}) {
    std::vector<Vec2> wheel;
    for (int i = 0; i <= 12; ++i) {
      const double a = 2 * std::numbers::pi * i / 12;
      wheel.push_back(hub + 0.21 * Vec2(std::cos(a), std::sin(a)));
    }
    draw(wheel);
  }
  draw({rear, pedals, head});
  draw({rear, Vec2(-0.13, 0.62), Vec2(0.18, 0.62)});
  draw({pedals, seat + Vec2(-0.02, 0.07)});
  draw({front, head, head + Vec2(-0.02, 0.14), head + Vec2(0.1, 0.17)});
  draw({seat + Vec2(-0.1, 0.08), seat + Vec2(0.06, 0.08)});
}

Mesh cycle_tracks(const StreetNetwork& network, int street, const Materials& m, std::uint64_t seed) {
  Mesh mesh{"cycle tracks " + network.streets[street].name, {}};
  const StreetProfile& p = network.streets[street].profile;
  Draws draws{substream(make_stream(seed, "cycle tracks"), street)};
  const bool red = draws.chance(0.5), dashed = draws.chance(0.35);
  for (const int s : network.streets[street].segments) {
    const Segment& segment = network.segments[s];
    const double from = segment.cut_from, to = length(segment.centre) - segment.cut_to;
    for (const bool left : {true, false}) {
      const double width = left ? p.cycle_left_m : p.cycle_right_m, side = left ? 1 : -1;
      if (width == 0) continue;
      const double outer = p.half_width() - (left ? p.parking_left_m : p.parking_right_m);
      const auto stripe = [&](MaterialId material, double from_m, double to_m, double from_middle_m,
                              double wide, double height_m, double tile_m) {
        add_stripe(mesh.surfaces[material], offset(cut(segment.centre, from_m, to_m), side * from_middle_m),
                   wide, height_m, tile_m);
      };
      if (red)  // leaves the gutter free
        stripe(m.cycle_track, from, to, outer - width / 2 - 0.15, width - 0.3, surface_height_m,
               asphalt_tile_m);
      const double line = outer - width;
      if (dashed)
        for (double a = from + 0.5; a + 1 < to; a += 2)
          stripe(m.road_paint, a, a + 1, line, 0.12, paint_height_m, paint_tile_m);
      else
        stripe(m.road_paint, from + 0.5, to - 0.5, line, 0.25, paint_height_m, paint_tile_m);
      for (double a = from + 12; a + 12 < to; a += 38) {
        const Station at = station_at(segment.centre, left ? from + to - a : a);
        paint_bicycle(mesh.surfaces[m.road_paint],
                      at.point + left_of(at.direction) * (side * (outer - width / 2 - 0.1)),
                      -side * at.direction, paint_height_m);
      }
    }
  }
  return mesh;
}

}  // namespace cps::city
