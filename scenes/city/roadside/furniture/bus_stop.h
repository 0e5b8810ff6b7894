#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

inline constexpr double shelter_half_length_m = 2.1, shelter_half_depth_m = 0.75;

/// A shelter with a bench and a poster, open towards +x, where the carriageway is; foot on the pavement.
Mesh bus_shelter(const Materials& materials);
/// The pole at the kerb with the stop's sign and timetable; it faces traffic as a traffic sign does.
Mesh bus_stop_sign(const Materials& materials);

}  // namespace cps::city
