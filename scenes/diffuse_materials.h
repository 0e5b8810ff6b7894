#pragma once

#include "scenes/scene.h"

namespace cps {

/// Reduces every material to a Lambert surface: base colour, alpha and emission. For comparisons with
/// renderers whose glossy materials differ.
void make_diffuse(Scene& scene);

}  // namespace cps
