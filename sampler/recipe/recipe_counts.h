#pragma once

#include <cstdint>

#include "sampler/recipe/recipe.h"

namespace cps {

/// How much of everything a recipe makes.
struct RecipeCounts {
  std::int64_t scenes = 0;      ///< files and procedural cities
  std::int64_t conditions = 0;  ///< scenes times lights
  std::int64_t sets = 0;        ///< sizes times H-FOVs
  std::int64_t groups = 0;      ///< leaf folders
  std::int64_t views = 0;       ///< renders
  std::int64_t images = 0;
};

/// Counted without drawing a lens or reading a scene: what make_plan() comes to, `cameras` on the rig.
RecipeCounts count_out(const Recipe& recipe, int cameras);

}  // namespace cps
