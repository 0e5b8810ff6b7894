#pragma once

#include <cstdint>
#include <vector>

#include "sampler/recipe/recipe.h"
#include "scenes/drive/driven_scene.h"
#include "scenes/rig.h"

namespace cps {

/// What images of one size cost after the render.
struct ImageCost {
  double cpu_s = 0;  ///< warp, develop, encode
  double bytes = 0;  ///< of the file
};

/// What a few views of a recipe took, really made. CPU seconds are those of all threads together.
struct Pilot {
  int views = 0, full_size_views = 0, images = 0;
  /// Of one view, by condition and then by set; rendered small, and multiplied by the pixels left out.
  std::vector<std::vector<double>> render_cpu_s;
  double full_size_ratio = 1;          ///< what full-size renders took over what was foretold from small ones
  std::vector<ImageCost> image_costs;  ///< by the recipe's sizes
  double scene_cpu_s = 0;              ///< to make a scene's file; 0 if it is there
  double scene_bytes = 0;              ///< of the file; 0 if it is there
  double condition_cpu_s = 0;          ///< to load a scene, twice, and make it ready to render
  double view_plan_cpu_s = 0;          ///< to draw a view's place and lenses
  std::int64_t peak_bytes = 0;         ///< of memory that the process had, with one view at a time
  std::int64_t view_bytes = 0;         ///< of memory, of the largest view rendered
};

/// Makes `conditions` scenes of the recipe (or all, if it has fewer) in a temporary folder and renders one
/// view of each set in each of them, small, and a few at full size, with all their images. Throws
/// std::runtime_error in one line when a scene is missing.
Pilot run_pilot(const Recipe& recipe, const Rig& rig, const DriveOptions& drive, int conditions);

}  // namespace cps
