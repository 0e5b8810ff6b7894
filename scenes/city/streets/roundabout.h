#pragma once

#include <optional>

#include "scenes/city/draws.h"
#include "scenes/city/streets/street_network.h"

/// Roundabouts with one lane, or two where wide streets meet, around a kerbed island; traffic circles
/// anticlockwise, seen from above.
namespace cps::city {

/// How many of the junctions with room for one a city of that style makes roundabouts: often none.
double draw_roundabout_share(CityStyle style, Draws& draws);

/// A roundabout for this junction with that probability, if its arms leave room; none beside another one.
std::optional<Roundabout> draw_roundabout(const StreetNetwork& network, int junction, double share,
                                          Draws& draws);

/// Distance from the middle to where the arm's own carriageway begins.
double roundabout_cut_m(const Roundabout& roundabout, double half_width_m);

/// A block's border from the line that arrives at the junction, around it, to the line that leaves; both
/// `inset_m` behind the kerb. Always the same number of points.
Polyline around_roundabout(const Roundabout& roundabout, const Vec2& middle, const Polyline& arriving,
                           const Polyline& leaving, double inset_m);

/// The way of a vehicle from the end of one lane around to the start of another, on the ring's `lane` (from
/// the outer kerb).
Polyline roundabout_way(const Roundabout& roundabout, const Vec2& middle, const Station& from,
                        const Station& to, int lane);

}  // namespace cps::city
