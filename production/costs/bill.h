#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "production/costs/pilot.h"
#include "sampler/recipe/recipe_counts.h"

namespace cps {

/// How the work is shared: among shards, each with so many threads.
struct Processes {
  std::int64_t shards = 1;
  int threads = 1;
};

/// Estimate of what a recipe takes. Core-hours are CPU time.
struct Bill {
  RecipeCounts counts;
  Processes processes;
  double render_core_h = 0, images_core_h = 0, scenes_core_h = 0;
  /// Of the light cache: at most, as if no view found any that another one had left.
  double cells_core_h = 0;
  double start_core_h = 0;  ///< of all processes: to load scenes and draw lenses and places
  double core_h = 0;        ///< the sum of these
  /// Standard error of core_h: from the spread between conditions, or between views if larger.
  double core_h_error = 0;
  double view_cpu_s_spread = 0;  ///< relative standard deviation of a view's render time within its set
  /// By set, in the plan's order (sizes, and for each its H-FOVs); excludes making scenes and the start.
  std::vector<double> set_images_per_core_h = {};
  double image_bytes = 0, scene_bytes = 0;  ///< on disk
  std::int64_t peak_bytes = 0;              ///< peak memory of one process
  int scenes_held = 1;                      ///< by one process at a time
};

/// Extrapolates the pilot's measurements to the whole recipe.
Bill bill_of(const Recipe& recipe, const RecipeCounts& counts, const Pilot& pilot,
             const Processes& processes);

/// What the user has, to compare the bill with.
struct Resources {
  int cores = 1;
  double price_per_core_h = 0;  ///< 0: not given
  std::string folder;           ///< the dataset's
  double free_bytes = 0;        ///< on the folder's disk
};

std::string to_text(const Recipe& recipe, const Bill& bill, const Pilot& pilot, const Resources& resources);
nlohmann::ordered_json to_json(const Recipe& recipe, const Bill& bill, const Pilot& pilot,
                               const Resources& resources);

}  // namespace cps
