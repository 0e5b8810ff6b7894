#pragma once

#include "scenes/city/streets/surface/road_markings.h"

namespace cps::city {

enum class Signal { none, red, green };

/// What the traffic light at one end of a segment (`at_end`: where the segment ends) shows to those who come
/// along it. All arms of a junction that have a crossing have one, or none has; those that face each other
/// show the same, those across the other. Which it is changes with the traffic.
Signal signal_at(const StreetNetwork& network, int segment, bool at_end, const CityOptions& options);

}  // namespace cps::city
