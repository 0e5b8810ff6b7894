#pragma once

#include <cstdint>

#include "sampler/recipe/recipe.h"

namespace cps {

/// Numbers of scenes, views, images … that a recipe makes.
struct RecipeCounts {
  std::int64_t scenes = 0;       ///< files and procedural cities
  std::int64_t conditions = 0;   ///< scenes times conditions per scene
  std::int64_t scene_files = 0;  ///< a city has one for each of its conditions
  std::int64_t sets = 0;         ///< sizes times H-FOVs
  std::int64_t groups = 0;       ///< leaf folders
  std::int64_t views = 0;        ///< renders
  std::int64_t images = 0;
};

/// The numbers of make_plan()'s plan for a rig of `cameras` cameras, without drawing a lens or reading a
/// scene.
RecipeCounts count_out(const Recipe& recipe, int cameras);

}  // namespace cps
