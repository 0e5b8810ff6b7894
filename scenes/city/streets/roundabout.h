#pragma once

#include <optional>

#include "scenes/city/draws.h"
#include "scenes/city/streets/street_network.h"

/// Roundabouts of one lane, or two where wide streets meet, around a kerbed island. Traffic circles
/// anticlockwise, seen from above.
namespace cps::city {

/// The city's share of roundabouts among junctions with room for one; often 0.
double draw_roundabout_share(CityStyle style, Draws& draws);

/// A roundabout for this junction, with probability `share` and if its arms leave room; never next to another
/// roundabout.
std::optional<Roundabout> draw_roundabout(const StreetNetwork& network, int junction, double share,
                                          Draws& draws);

/// Distance from the junction's position to the beginning of an arm's own carriageway.
double roundabout_cut_m(const Roundabout& roundabout, double half_width_m);

/// A block's border around the roundabout, from the line that arrives at the junction to the line that
/// leaves, both `inset_m` behind the kerb. The number of points is always the same.
Polyline around_roundabout(const Roundabout& roundabout, const Vec2& middle, const Polyline& arriving,
                           const Polyline& leaving, double inset_m);

/// The path of a vehicle from the end of one lane to the start of another, around on the ring's lane number
/// `lane`, counted from the outer kerb.
Polyline roundabout_way(const Roundabout& roundabout, const Vec2& middle, const Station& from,
                        const Station& to, int lane);

}  // namespace cps::city
