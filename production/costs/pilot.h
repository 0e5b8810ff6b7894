#pragma once

#include <cstdint>
#include <vector>

#include "production/watch.h"
#include "sampler/recipe/recipe.h"
#include "scenes/drive/driven_scene.h"
#include "scenes/rig.h"

namespace cps {

/// What an image costs after the render, by the image's size.
struct ImageCost {
  double cpu_s = 0;  ///< to warp, develop and encode it, and its dense labels
  double bytes = 0;  ///< of its files
};

/// What a process of cps generate spends before it renders, in CPU seconds.
struct StartCosts {
  double group_cpu_s = 0;       ///< to plan a group: mostly to draw its lens
  double scene_load_cpu_s = 0;  ///< to hash a scene's file, load it and trace rays in it
  double view_place_cpu_s = 0;  ///< to draw the place of a view
  double condition_cpu_s = 0;   ///< to load a condition's scene and prepare it for rendering
};

/// Measurements of a few views of a recipe. CPU seconds are those of all threads together.
struct Pilot {
  int views = 0, full_size_views = 0, images = 0;
  /// Of one view, by condition and then by set, without the light cache's cells: measured on a smaller render
  /// and scaled up by pixel count.
  std::vector<std::vector<double>> render_cpu_s;
  double cells_cpu_s = 0;              ///< of one view, for the cells of the light cache that it asks for
  double full_size_ratio = 1;          ///< time of full-size renders over that estimated from small ones
  std::vector<ImageCost> image_costs;  ///< by the recipe's sizes
  double city_cpu_s = 0;               ///< to make a scene's file; 0 if the file exists
  double scene_bytes = 0;              ///< of the file; 0 if it existed
  StartCosts start;
  std::int64_t peak_bytes = 0;          ///< peak memory of the process, with one view and one scene at a time
  std::int64_t view_bytes = 0;          ///< memory of the largest render
  std::int64_t scene_memory_bytes = 0;  ///< estimated for the largest scene, while it is loaded and rendered
};

/// Takes `conditions` conditions of the recipe (or all, if it has fewer) and renders one view of each set in
/// each of them at a reduced size, and a few at full size with all their images, in a temporary folder.
/// The watch hears of each scene as in load_scene(). Throws std::runtime_error in one line when a scene is
/// missing.
Pilot run_pilot(const Recipe& recipe, const Rig& rig, const DriveOptions& drive, int conditions,
                const Watch& watch);

}  // namespace cps
