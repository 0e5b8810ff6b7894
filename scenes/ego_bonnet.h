#pragma once

#include "scenes/scene.h"

namespace cps {

/// Gives the scene the bonnet of the car that carries the cameras: a saloon's, 2.15 to 3.55 m before the rear
/// axle, its top 0.7 to 1 m high, 1.7 m wide, in dark paint. It rides with the car.
void add_ego_bonnet(Scene& scene);

}  // namespace cps
