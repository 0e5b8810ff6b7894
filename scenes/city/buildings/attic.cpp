#include "scenes/city/buildings/attic.h"

#include <algorithm>

#include "scenes/city/buildings/opening.h"

namespace cps::city {

void add_dormers(Mesh& mesh, const Footprint& f, double foot, double slope, double start, const Materials& m,
                 Draws& draws) {
  const double width = draws.uniform(1.2, 1.7), spacing = draws.uniform(3.2, 5.5), height = 1.45;
  const double sill = foot + slope * start;  // height of the slope at the dormer's front
  for (std::size_t i = 1; i < f.front.size(); ++i) {
    const Vec2 a = f.front[i - 1], b = f.front[i], along = (b - a).normalized(), in = left_of(along);
    const double room = (b - a).norm() - 5, deep = height / slope + 0.25;
    const int count = static_cast<int>(room / spacing);
    for (int k = 0; k < count; ++k) {
      const Vec2 middle = a + along * (2.5 + room * (k + 0.5) / count) + in * (start + deep / 2);
      add_box(mesh.surfaces[m.roof_metal], middle, along, width / 2, deep / 2, sill - 0.1, sill + height);
      add_box(mesh.surfaces[m.roof_metal], middle - in * 0.1, along, width / 2 + 0.12, deep / 2,
              sill + height, sill + height + 0.1, 1, true);
      const WallFrame frame{middle - in * (deep / 2) - along * (width / 2), along, -in};
      add_bar(mesh.surfaces[m.frame_white], frame, {0.1, width - 0.1, sill + 0.15, sill + height - 0.1}, 0,
              0.03);
      for (const auto& [u0, u1] : {std::pair{0.18, width / 2 - 0.03}, {width / 2 + 0.03, width - 0.18}})
        add_panel(mesh.surfaces[m.glass], frame, {u0, u1, sill + 0.23, sill + height - 0.18}, 0.034);
    }
  }
}

void add_gable_window(Mesh& mesh, const Footprint& f, bool at_end, double eaves, double rise,
                      const Materials& m) {
  const std::size_t i = at_end ? f.front.size() - 1 : 0;
  const Vec2 near = f.at(i, 0), far = f.at(i, f.depth_m);
  const WallFrame frame = at_end ? make_wall_frame(near, far) : make_wall_frame(far, near);
  const double middle = f.depth_m / 2, half = 0.5, bottom = eaves + 0.35;
  const double top = std::min(bottom + 1.3, eaves + rise * 0.62);
  add_bar(mesh.surfaces[m.frame_white], frame,
          {middle - half - 0.08, middle + half + 0.08, bottom - 0.08, top + 0.08}, 0, 0.035);
  for (const double side : {-1.0, 1.0}) {
    const double a = middle + side * 0.03, b = middle + side * half;
    add_panel(mesh.surfaces[m.glass], frame, {std::min(a, b), std::max(a, b), bottom, top}, 0.039);
  }
}

}  // namespace cps::city
