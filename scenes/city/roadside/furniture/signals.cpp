#include "scenes/city/roadside/furniture/signals.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/draws.h"

namespace cps::city {
namespace {

/// The direction of an arm, away from its junction (unit).
Vec2 direction_of(const StreetNetwork& network, const Side& arm) {
  const Polyline line = network.line(arm, 0);
  return (line[1] - line[0]).normalized();
}

}  // namespace

Signal signal_at(const StreetNetwork& network, int segment, bool at_end, const CityOptions& options) {
  const Segment& s = network.segments[segment];
  const bool quiet = network.streets[s.street].profile.kind == "residential";
  if (quiet || !approach(network, segment, at_end, options.seed).crossing) return Signal::none;
  const int junction = at_end ? s.to : s.from;
  if (network.junctions[junction].roundabout) return Signal::none;
  if (!Draws{substream(make_stream(options.seed, "signals"), junction)}.chance(0.6)) return Signal::none;
  Draws phase{substream(moving_stream(options, "signals' phases"), junction)};
  const std::vector<Side>& arms = network.junctions[junction].arms;
  const auto first =
      std::find_if(arms.begin(), arms.end(), [&](const Side& a) { return network.is_road(a); });
  const double across =
      std::abs(cross(direction_of(network, *first), direction_of(network, Side{segment, at_end})));
  return (across < 0.7) == phase.chance(0.5) ? Signal::green : Signal::red;
}

}  // namespace cps::city
