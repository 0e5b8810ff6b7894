#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "production/costs/pilot.h"
#include "sampler/recipe/recipe_counts.h"

namespace cps {

/// What a recipe will take. Core-hours are CPU time.
struct Bill {
  RecipeCounts counts;
  double render_core_h = 0, images_core_h = 0, scenes_core_h = 0, plan_core_h = 0;
  double core_h = 0;             ///< the sum of these
  double core_h_error = 0;       ///< its standard error, by how conditions differ, or views if that says more
  double view_cpu_s_spread = 0;  ///< standard deviation of a view's render over its mean, within its set
  /// Of each set, in the plan's order: size by size, H-FOV by H-FOV. Without scenes and places.
  std::vector<double> set_images_per_core_h = {};
  double image_bytes = 0, scene_bytes = 0;  ///< on disk
  std::int64_t peak_bytes = 0;              ///< of memory, of one process
};

/// What the pilot's measurements come to for the whole recipe, made by processes of so many threads.
Bill bill_of(const Recipe& recipe, const RecipeCounts& counts, const Pilot& pilot, int threads);

/// What a bill is held against.
struct Resources {
  int cores = 1;
  double price_per_core_h = 0;  ///< 0: none was said
  std::string folder;           ///< where the dataset would go
  double free_bytes = 0;        ///< there
};

std::string to_text(const Recipe& recipe, const Bill& bill, const Pilot& pilot, const Resources& resources);
nlohmann::ordered_json to_json(const Recipe& recipe, const Bill& bill, const Pilot& pilot,
                               const Resources& resources);

}  // namespace cps
