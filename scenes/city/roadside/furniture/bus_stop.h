#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

inline constexpr double shelter_half_length_m = 2.1, shelter_half_depth_m = 0.75;

/// A shelter with a bench and a poster, open towards the carriageway (+x), foot on the pavement.
Mesh bus_shelter(const Materials& materials);
/// A pole with the stop's sign and timetable, facing the traffic like a traffic sign.
Mesh bus_stop_sign(const Materials& materials);

}  // namespace cps::city
