#include "scenes/city/roadside/pavement_tracks.h"

#include <algorithm>

#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/cycle_tracks.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {

Polyline pavement_track(const StreetNetwork& network, const KerbSide& kerb) {
  constexpr double min_length_m = 8;
  const double width = network.profile(kerb.side).pavement_cycle_m;
  if (width == 0 || kerb.to - kerb.from < min_length_m) return {};
  Polyline line =
      offset(cut(kerb.centre, kerb.from, kerb.to), kerb.half_width + pavement_track_inset_m + width / 2);
  if (!kerb.runs_with_traffic) std::reverse(line.begin(), line.end());
  return line;
}

Mesh pavement_tracks(const StreetNetwork& network, int street, const Materials& m,
                     const CityOptions& options) {
  constexpr double first_symbol_m = 4, symbol_spacing_m = 36;
  Mesh mesh{"pavement tracks " + network.streets[street].name, {}};
  const double width = network.streets[street].profile.pavement_cycle_m,
               height = kerb_height_m + pavement_track_rise_m;
  if (width == 0) return mesh;
  for (const int segment : network.streets[street].segments)
    for (const bool reversed : {false, true}) {
      const Polyline line = pavement_track(network, kerb_side(network, {segment, reversed}, 0, options));
      if (line.empty()) continue;
      add_stripe(mesh.surfaces[m.cycle_track], line, width, height, asphalt_tile_m);
      for (double s = first_symbol_m; s + first_symbol_m < length(line); s += symbol_spacing_m) {
        const Station at = station_at(line, s);
        paint_bicycle(mesh.surfaces[m.road_paint], at.point, at.direction, height + 0.003);
      }
    }
  return mesh;
}

}  // namespace cps::city
