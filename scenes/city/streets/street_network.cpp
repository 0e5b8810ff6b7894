#include "scenes/city/streets/street_network.h"

#include <algorithm>
#include <cmath>

namespace cps::city {

Polyline StreetNetwork::line(const Side& side, double left_m) const {
  Polyline centre = segments[side.segment].centre;
  if (side.reversed) std::reverse(centre.begin(), centre.end());
  return offset(centre, left_m);
}

Polyline StreetNetwork::kerb_line(const Side& side, double inset_m) const {
  return line(side, segments[side.segment].half_width + inset_m);
}

double StreetNetwork::corner_radius(const Side& side) const {
  const Junction& junction = junctions[end(side)];
  const Side twin{side.segment, !side.reversed};
  const auto arm = std::find(junction.arms.begin(), junction.arms.end(), twin);
  const std::size_t i = arm - junction.arms.begin();
  return junction.radii[(i + junction.arms.size() - 1) % junction.arms.size()];
}

void find_blocks(StreetNetwork& network) {
  for (Junction& junction : network.junctions) junction.arms.clear();
  for (int s = 0; s < static_cast<int>(network.segments.size()); ++s) {
    network.junctions[network.segments[s].from].arms.push_back({s, false});
    network.junctions[network.segments[s].to].arms.push_back({s, true});
  }
  const auto heading = [&](const Side& side) {
    const Polyline line = network.line(side, 0);
    return std::atan2(line[1].y() - line[0].y(), line[1].x() - line[0].x());
  };
  for (Junction& junction : network.junctions)
    std::sort(junction.arms.begin(), junction.arms.end(),
              [&](const Side& a, const Side& b) { return heading(a) < heading(b); });

  network.blocks.clear();
  std::vector<std::array<bool, 2>> seen(network.segments.size(), {false, false});
  for (int s = 0; s < static_cast<int>(network.segments.size()); ++s)
    for (const bool reversed : {false, true}) {
      if (seen[s][reversed]) continue;
      Block block;
      Polygon corners;
      Side side{s, reversed};
      do {  // keep left: at each junction take the next arm clockwise from the arm just walked
        seen[side.segment][side.reversed] = true;
        block.sides.push_back(side);
        block.at_rim |= !network.is_road(side);
        corners.push_back(network.junctions[network.start(side)].position);
        const std::vector<Side>& arms = network.junctions[network.end(side)].arms;
        const auto back = std::find(arms.begin(), arms.end(), Side{side.segment, !side.reversed});
        side = arms[(back - arms.begin() + arms.size() - 1) % arms.size()];
      } while (!(side == Side{s, reversed}));
      if (signed_area(corners) > 0) network.blocks.push_back(std::move(block));
    }
}

}  // namespace cps::city
