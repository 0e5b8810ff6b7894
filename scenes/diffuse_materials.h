#pragma once

#include "scenes/scene.h"

namespace cps {

/// Leaves of every material only what a Lambert surface has: base colour and alpha, and emission. For
/// comparisons with renderers whose glossy materials differ.
void make_diffuse(Scene& scene);

}  // namespace cps
