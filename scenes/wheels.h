#pragma once

#include "scenes/rig.h"
#include "scenes/scene_rays.h"

namespace cps {

/// The place with height, pitch and roll from the ground below the car's four wheels (wheelbase 2.7 m, track
/// 1.55 m). Ground is a surface within 0.6 m of the place's height and no steeper than 35°. If a wheel finds
/// none, returns the place unchanged.
Place on_wheels(const SceneRays& rays, const Place& place);

}  // namespace cps
