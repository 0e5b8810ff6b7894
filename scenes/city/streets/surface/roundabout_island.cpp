#include "scenes/city/streets/surface/roundabout_island.h"

#include <numbers>

#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {

Mesh island(const Roundabout& r, const Vec2& middle, const Materials& m) {
  constexpr double paved_m = 1.3;
  Mesh mesh{"island", {}};
  const auto circle = [&](double radius_m) {
    return arc(middle, middle + Vec2(radius_m, 0), 2 * std::numbers::pi, 48);
  };
  const auto ring = [&](MaterialId material, double outer_m, double outer_z, double inner_m, double inner_z,
                        double tile_m) {
    add_strip(mesh.surfaces[material], circle(inner_m), circle(outer_m), {inner_z, outer_z, tile_m});
  };
  const double kerb = r.island_m, top = kerb_height_m;
  ring(m.kerb, kerb, -0.05, kerb, top, kerb_tile_m);
  ring(m.kerb, kerb, top, kerb - kerb_width_m, top, kerb_tile_m);
  ring(m.paving, kerb - kerb_width_m, top, kerb - paved_m, top, paving_tile_m);
  const double lawn = kerb - paved_m;
  const auto mound = [&](double share) { return top + 0.035 * lawn * (1 - share * share); };
  for (int k = 4; k > 0; --k) {
    const double outer = k / 4.0, inner = (k - 1) / 4.0;
    ring(m.grass, lawn * outer, mound(outer), lawn * inner, mound(inner), grass_tile_m);
  }
  Surface& grass = mesh.surfaces[m.grass];
  for (std::size_t i = 0; i < grass.positions.size();
       ++i)  // mapped from above, so that the texture does not fan out
    grass.uvs[i] =
        Eigen::Vector2f(grass.positions[i].x(), grass.positions[i].z()) / static_cast<float>(grass_tile_m);
  return mesh;
}

}  // namespace cps::city
