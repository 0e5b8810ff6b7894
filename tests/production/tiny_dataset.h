#pragma once

#include <map>
#include <set>

#include "dataset/job/journal.h"
#include "files/files.h"
#include "production/dataset_job.h"
#include "production/make_views.h"
#include "production/remaining_views.h"
#include "sampler/recipe/rig_file.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

namespace cps {

/// Of each scene six views under two conditions, with two images each: rendered in a second.
inline Recipe tiny_recipe(const std::vector<std::filesystem::path>& scenes) {
  Recipe recipe;
  recipe.seed = 3;
  for (const std::filesystem::path& scene : scenes) recipe.scenes.push_back(scene.string());
  recipe.sizes = {{80, 45}};
  recipe.base_hfov_deg = {70};
  recipe.views = 6 * static_cast<int>(scenes.size());
  recipe.lenses = 1;
  recipe.conditions_per_scene = 2;
  recipe.samples = 2;
  return recipe;
}

/// Writes street.gltf, a street of boxes, and as many copies of it, street1.gltf …, as make `count` scenes.
inline std::vector<std::filesystem::path> write_streets(const std::filesystem::path& folder, int count) {
  std::vector<std::filesystem::path> scenes{write_street_gltf(folder)};
  for (int i = 1; i < count; ++i) {
    scenes.push_back(folder / ("street" + std::to_string(i) + ".gltf"));
    std::filesystem::copy_file(scenes[0], scenes.back());
  }
  return scenes;
}

/// A planned dataset of which nothing is made yet.
struct TinyDataset {
  int scene_count = 1;
  TemporaryFolder folder = {};
  std::vector<std::filesystem::path> scenes = write_streets(folder.path, scene_count);
  std::filesystem::path scene = scenes[0], root = folder.path / "dataset";
  DatasetJob job = new_job(tiny_recipe(scenes), find_rig("", {}), {}, root);
  Plan plan = plan_of(job, {});

  /// Views that remain, by what the folder holds.
  std::vector<std::int64_t> remaining(const Watch& watch = {}) const {
    return remaining_views(plan, {}, root, watch).views;
  }

  /// Makes what remains, as generate does.
  MakeViewsSummary make(const Watch& watch = {}) const {
    Journal journal(root, {});
    return make_views(plan, remaining(), journal, root, 2, watch);
  }

  /// Names of a view's images, relative to the dataset.
  std::vector<std::string> files_of(std::int64_t view) const {
    std::vector<std::string> files;
    for (int g : plan.views[view].groups)
      files.push_back(plan.groups[g].folder + "/" + image_name(plan, plan.views[view]));
    return files;
  }

  /// Every file but journals and locks, by name.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      const std::filesystem::path name = entry.path().lexically_relative(root);
      if (entry.is_regular_file() && *name.begin() != ".cps") files[name.string()] = read_file(entry.path());
    }
    return files;
  }
};

}  // namespace cps
