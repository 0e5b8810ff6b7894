#include "scenes/city/streets/median.h"

#include "scenes/city/draws.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/road_markings.h"
#include "scenes/city/streets/road_surface.h"

namespace cps::city {
namespace {

void add_island(Mesh& mesh, const Polyline& middle, double width_m, MaterialId cover, double tile_m,
                const Materials& m) {
  const auto side = [&](double left_m) { return offset(middle, left_m); };
  const double half = width_m / 2, inner = half - kerb_width_m;
  Polygon ring = side(-half);
  const Polyline left = side(half);
  ring.insert(ring.end(), left.rbegin(), left.rend());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Polyline piece{ring[i], ring[(i + 1) % ring.size()]};
    add_strip(mesh.surfaces[m.kerb], piece, piece, {kerb_height_m, -0.05, kerb_tile_m});
  }
  const StripStyle on_kerb{kerb_height_m, kerb_height_m, kerb_tile_m};
  add_strip(mesh.surfaces[m.kerb], side(half), side(inner), on_kerb);
  add_strip(mesh.surfaces[m.kerb], side(-inner), side(-half), on_kerb);
  add_strip(mesh.surfaces[cover], side(inner), side(-inner), {kerb_height_m, kerb_height_m, tile_m});
}

}  // namespace

Mesh median(const StreetNetwork& network, int street, const Materials& m, std::uint64_t seed) {
  constexpr double behind_line_m = 0.6, shortest_m = 6;
  Mesh mesh{"median " + network.streets[street].name, {}};
  const StreetProfile& p = network.streets[street].profile;
  if (p.median_m == 0) return mesh;
  Draws draws{substream(make_stream(seed, "median"), street)};
  const bool green = draws.chance(0.6);
  for (const int s : network.streets[street].segments) {
    const Segment& segment = network.segments[s];
    const double from = segment.cut_from + approach(network, s, false, seed).stop_line_at_m + behind_line_m;
    const double to = length(segment.centre) - segment.cut_to -
                      approach(network, s, true, seed).stop_line_at_m - behind_line_m;
    if (to - from < shortest_m) continue;
    add_island(mesh, offset(cut(segment.centre, from, to), p.divider_offset()), p.median_m,
               green ? m.grass : m.paving, green ? grass_tile_m : paving_tile_m, m);
  }
  return mesh;
}

}  // namespace cps::city
