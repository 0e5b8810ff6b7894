#include "scenes/city/streets/surface/tram_tracks.h"

#include <algorithm>

#include "scenes/city/geometry/strip.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

constexpr double head_m = 0.06, groove_m = 0.04, bed_m = 0.24;

/// The street's centre line, across its junctions, but not into the junctions at its two ends.
Polyline whole_line(const StreetNetwork& network, const Street& street) {
  Polyline line;
  for (const int s : street.segments) {
    const Segment& segment = network.segments[s];
    const bool is_first = s == street.segments.front(), is_last = s == street.segments.back();
    const Polyline piece = cut(segment.centre, is_first ? segment.cut_from : 0,
                               length(segment.centre) - (is_last ? segment.cut_to : 0));
    line.insert(line.end(), piece.begin() + (line.empty() ? 0 : 1), piece.end());
  }
  return line;
}

}  // namespace

std::vector<TramTrack> tram_tracks(const StreetNetwork& network) {
  std::vector<TramTrack> tracks;
  for (std::size_t s = 0; s < network.streets.size(); ++s) {
    const StreetProfile& p = network.streets[s].profile;
    if (!p.tram_tracks) continue;
    const Polyline line = whole_line(network, network.streets[s]);
    const auto add = [&](double left_m) { tracks.push_back({static_cast<int>(s), offset(line, left_m)}); };
    if (p.lanes_forward > 0) add(p.forward_lane_offset(p.lanes_forward - 1));
    if (p.lanes_backward == 0) continue;
    add(p.backward_lane_offset(p.lanes_backward - 1));
    std::reverse(tracks.back().centre.begin(), tracks.back().centre.end());
  }
  return tracks;
}

Mesh tram_rails(const TramTrack& track, const Materials& m) {
  Mesh mesh{"tram track", {}};
  for (const double side : {-1.0, 1.0}) {
    const auto stripe = [&](MaterialId material, double from_middle_m, double width_m, double height_m) {
      add_stripe(mesh.surfaces[material], offset(track.centre, side * from_middle_m), width_m, height_m, 1);
    };
    const double inner_face = tram_gauge_m / 2;
    stripe(m.tar, inner_face, bed_m, seam_height_m + 0.001);  // joint between rail and asphalt
    stripe(m.rail, inner_face + head_m / 2, head_m, paint_height_m + 0.002);
    stripe(m.manhole, inner_face - groove_m - 0.015, 0.03,
           paint_height_m + 0.001);  // other edge of the groove
  }
  return mesh;
}

}  // namespace cps::city
