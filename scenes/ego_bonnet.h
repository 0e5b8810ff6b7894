#pragma once

#include "scenes/scene.h"

namespace cps {

/// Adds the bonnet of the car that carries the cameras, as an instance that rides with the car: a saloon's in
/// dark paint, 2.15 to 3.55 m ahead of the rear axle, 0.7 to 1 m high, 1.7 m wide.
void add_ego_bonnet(Scene& scene);

}  // namespace cps
