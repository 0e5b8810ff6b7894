#include "scenes/city/streets/surface/median.h"

#include "scenes/city/draws.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/heights.h"
#include "scenes/city/streets/surface/kerbed_island.h"
#include "scenes/city/streets/surface/road_markings.h"

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

/// Distance from the end of the segment's own carriageway to the median.
double median_from_m(const Approach& approach) {
  constexpr double behind_line_m = 0.6, beside_crossing_m = 0.3;
  return approach.crossing ? approach.crossing_from_m + approach.crossing_length_m + beside_crossing_m
                           : approach.stop_line_at_m + behind_line_m;
}

}  // namespace

Polygon refuge_nose(const StreetNetwork& network, int segment, bool at_end, std::uint64_t seed) {
  constexpr double into_junction_m = 0.7, before_crossing_m = 0.2, lane_gap_m = 0.2, taper_m = 0.35;
  const Segment& s = network.segments[segment];
  const StreetProfile& p = network.streets[s.street].profile;
  const Approach a = approach(network, segment, at_end, seed);
  if (p.median_m == 0 || !a.crossing) return {};
  const Station mouth = station_at(network.line({segment, at_end}, 0), at_end ? s.cut_to : s.cut_from);
  const double divider_m = p.divider_offset() * (at_end ? -1 : 1), half = p.median_m / 2 - lane_gap_m,
               tip = -into_junction_m, base = a.crossing_from_m - before_crossing_m;
  const auto at = [&](double along, double aside) {
    return Vec2(mouth.point + mouth.direction * along + left_of(mouth.direction) * (divider_m + aside));
  };
  return {at(tip, -0.5 * half), at(tip + taper_m, -half), at(base, -half),
          at(base, half),       at(tip + taper_m, half),  at(tip, 0.5 * half)};
}

Mesh median(const StreetNetwork& network, int street, const Materials& m, std::uint64_t seed) {
  constexpr double min_length_m = 6;
  Mesh mesh{"median " + network.streets[street].name, {}};
  const StreetProfile& p = network.streets[street].profile;
  if (p.median_m == 0) return mesh;
  Draws draws{substream(make_stream(seed, "median"), street)};
  const bool green = draws.chance(0.6);
  for (const int s : network.streets[street].segments) {
    const Segment& segment = network.segments[s];
    const double from = segment.cut_from + median_from_m(approach(network, s, false, seed));
    const double to =
        length(segment.centre) - segment.cut_to - median_from_m(approach(network, s, true, seed));
    if (to - from < min_length_m) continue;
    for (const bool at_end : {false, true})
      if (const Polygon nose = refuge_nose(network, s, at_end, seed); !nose.empty())
        add_kerbed_island(mesh, nose, m.paving, paving_tile_m, m);
    add_island(mesh, offset(cut(segment.centre, from, to), p.divider_offset()), p.median_m,
               green ? m.grass : m.paving, green ? grass_tile_m : paving_tile_m, m);
  }
  return mesh;
}

}  // namespace cps::city
