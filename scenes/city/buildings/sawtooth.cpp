#include <algorithm>
#include <cmath>

#include "scenes/city/buildings/roof.h"

namespace cps::city {

double add_sawtooth(Mesh& mesh, const Footprint& f, double eaves, const RoofPlan& plan, const Materials& m) {
  const Vec2 a = f.front[0], along = (f.front[1] - a).normalized(), in = left_of(along) * f.depth_m;
  const double total = (f.front[1] - a).norm(), tile = plan.wall.tile_m;
  const int teeth = std::max(1, static_cast<int>(std::lround(total / 7.5)));
  const double width = total / teeth, rise = std::min(2.8, 0.4 * width), slope = std::hypot(width, rise);
  for (int k = 0; k < teeth; ++k) {
    const Vec2 low = a + along * (k * width), high_foot = low, next = a + along * ((k + 1) * width);
    const Vec3 p0 = lift(high_foot, eaves), p1 = lift(high_foot, eaves + rise), q = lift(next, eaves);
    const Vec3 p0_in = lift(low + in, eaves), p1_in = lift(low + in, eaves + rise),
               q_in = lift(next + in, eaves);
    const double d = f.depth_m / tile;
    // The glazed face looks backwards along the front; the slope's ribs run down the slope.
    const double sill = 0.5 / rise;
    const Vec3 s0 = p0 + (p1 - p0) * sill, s0_in = p0_in + (p1_in - p0_in) * sill;
    add_quad(mesh.surfaces[plan.wall.material], {p0_in, {0, 0}}, {p0, {d, 0}}, {s0, {d, -0.5 / tile}},
             {s0_in, {0, -0.5 / tile}});
    add_quad(mesh.surfaces[m.glass], {s0_in}, {s0}, {p1}, {p1_in});
    add_quad(mesh.surfaces[plan.cover], {p1, {0, 0}}, {q, {0, slope / tile}}, {q_in, {d, slope / tile}},
             {p1_in, {d, 0}});
    Surface& wall = mesh.surfaces[plan.wall.material];
    add_polygon(wall, {{p0, {0, 0}}, {q, {width / tile, 0}}, {p1, {0, -rise / tile}}});
    add_polygon(wall, {{q_in, {0, 0}}, {p0_in, {width / tile, 0}}, {p1_in, {width / tile, -rise / tile}}});
  }
  return eaves + rise;
}

}  // namespace cps::city
