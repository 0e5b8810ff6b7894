#pragma once

#include "scenes/city/city_options.h"
#include "scenes/city/streets/surface/road_markings.h"

namespace cps::city {

enum class Signal { none, red, green };

/// The state of the traffic light at one end of a segment (`at_end`: its last junction), for traffic that
/// arrives there. Either all arms of a junction with a pedestrian crossing have a light, or none has.
/// Opposite arms show the same, crossing arms the other colour. The phase depends on the traffic seed.
Signal signal_at(const StreetNetwork& network, int segment, bool at_end, const CityOptions& options);

}  // namespace cps::city
