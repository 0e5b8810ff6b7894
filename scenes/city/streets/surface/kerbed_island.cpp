#include "scenes/city/streets/surface/kerbed_island.h"

#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {

void add_kerbed_island(Mesh& mesh, const Polygon& outline, MaterialId cover, double tile_m,
                       const Materials& m) {
  const std::vector<Vec2> inwards = inward_miters(outline);
  Polygon inner;
  for (std::size_t i = 0; i < outline.size(); ++i) inner.push_back(outline[i] + inwards[i] * kerb_width_m);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t k = (i + 1) % outline.size();
    const Polyline outer{outline[i], outline[k]}, inside{inner[i], inner[k]};
    add_strip(mesh.surfaces[m.kerb], outer, outer, {kerb_height_m, -0.05, kerb_tile_m});
    add_strip(mesh.surfaces[m.kerb], inside, outer, {kerb_height_m, kerb_height_m, kerb_tile_m});
  }
  add_floor(mesh.surfaces[cover], inner, kerb_height_m, tile_m);
}

}  // namespace cps::city
