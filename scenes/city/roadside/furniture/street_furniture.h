#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// Things on the pavement: foot at the origin on the pavement's surface, +x towards the carriageway.
Mesh street_lamp(const Materials& materials, double height_m, double arm_m);
Mesh bollard(const Materials& materials);
Mesh bin(const Materials& materials);
Mesh bench(const Materials& materials);
Mesh switch_box(const Materials& materials);

enum class SignKind { no_stopping, yield, priority, parking, crossing, speed };
/// A pole with a sign that faces the traffic, which comes along −y of the plan when +x is towards the
/// carriageway.
Mesh traffic_sign(const Materials& materials, SignKind kind);
Mesh traffic_light(const Materials& materials, bool green);

}  // namespace cps::city
