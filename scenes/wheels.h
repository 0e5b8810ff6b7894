#pragma once

#include "scenes/rig.h"
#include "scenes/scene_rays.h"

namespace cps {

/// The place with the height, pitch and roll that four wheels give the car there: the plane through the
/// ground below them (wheelbase 2.7 m, track 1.55 m). Ground is what lies within 0.6 m of the place's own
/// height and is no steeper than 35°; where a wheel finds none, the place stays as it is.
Place on_wheels(const SceneRays& rays, const Place& place);

}  // namespace cps
