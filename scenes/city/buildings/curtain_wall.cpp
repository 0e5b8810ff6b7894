#include "scenes/city/buildings/curtain_wall.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/buildings/opening.h"
#include "scenes/city/materials/textures.h"

namespace cps::city {

CurtainStyle draw_curtain_style(const Materials& m, Draws& draws) {
  CurtainStyle s;
  s.glass = draws.one_of(m.curtain_wall);
  const double solid = draws.uniform(0, 1);
  s.solid = solid < 0.45 ? draws.one_of(m.concrete) : solid < 0.7 ? m.stone : draws.one_of(m.plaster);
  const double pick = draws.uniform(0, 1);
  s.relief = pick < 0.2    ? CurtainRelief::none
             : pick < 0.4  ? CurtainRelief::fins
             : pick < 0.65 ? CurtainRelief::bands
                           : CurtainRelief::grid;
  s.storey_m = draws.uniform(3.4, 3.9);
  s.panels_per_pier = draws.integer(1, 3);
  const bool slim = s.relief == CurtainRelief::fins;
  s.pier_width_m = slim ? draws.uniform(0.08, 0.2) : draws.uniform(0.35, 0.9);
  s.pier_depth_m = draws.uniform(0.2, 0.5);
  s.band_height_m = s.relief == CurtainRelief::grid ? draws.uniform(0.4, 1.0) : draws.uniform(0.9, 1.6);
  s.band_depth_m = draws.uniform(0.08, s.pier_depth_m - 0.06);
  s.first_panel = draws.integer(0, curtain_wall_panels - 1);
  s.first_storey = draws.integer(0, curtain_wall_storeys - 1);
  return s;
}

void add_curtain_wall(Mesh& mesh, const Vec2& from, const Vec2& to, double bottom, int storeys,
                      const CurtainStyle& s) {
  const WallFrame frame = make_wall_frame(from, to);
  const double width = (to - from).norm(), top = bottom + storeys * s.storey_m;
  const int panels = std::max(1, static_cast<int>(std::lround(width / curtain_panel_m)));
  const double u0 = static_cast<double>(s.first_panel) / curtain_wall_panels,
               u1 = u0 + static_cast<double>(panels) / curtain_wall_panels;
  const double v0 = -static_cast<double>(s.first_storey) / curtain_wall_storeys,
               v1 = v0 - static_cast<double>(storeys) / curtain_wall_storeys;
  add_quad(mesh.surfaces[s.glass.material], {frame.point(0, bottom, 0), {u0, v0}},
           {frame.point(width, bottom, 0), {u1, v0}}, {frame.point(width, top, 0), {u1, v1}},
           {frame.point(0, top, 0), {u0, v1}});
  Surface& solid = mesh.surfaces[s.solid.material];
  if (s.relief == CurtainRelief::bands || s.relief == CurtainRelief::grid)
    for (int k = 0; k < storeys; ++k)  // extended around one corner, where it meets the next wall's band
      add_bar(solid, frame,
              {0, width + s.band_depth_m, bottom + k * s.storey_m, bottom + k * s.storey_m + s.band_height_m},
              0, s.band_depth_m, s.solid.tile_m, lower_face | upper_face | right_face);
  if (s.relief == CurtainRelief::fins || s.relief == CurtainRelief::grid)
    for (int p = 0; p <= panels; p += s.panels_per_pier) {
      const double u = std::clamp(width * p / panels, s.pier_width_m / 2, width - s.pier_width_m / 2);
      add_bar(solid, frame, {u - s.pier_width_m / 2, u + s.pier_width_m / 2, bottom, top}, 0, s.pier_depth_m,
              s.solid.tile_m, left_face | right_face);
    }
}

}  // namespace cps::city
