#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sampler/plan/scene_plan.h"
#include "scenes/scene.h"

namespace cps {

/// Makes the files of procedural cities that are not there yet. Processes that do so at the same time share
/// the work: a city is made by the one that holds its lock in `lock_folder`. Throws std::runtime_error when
/// another scene's file is missing.
void make_scene_files(const std::vector<PlannedScene>& scenes, const std::filesystem::path& lock_folder);

/// The scene as its views see it: in metres, with the car's bonnet where the recipe wants it.
Scene load_scene(const PlannedScene& planned, const Recipe& recipe);

/// SHA-256 of each file.
std::vector<std::string> scene_hashes(const std::vector<PlannedScene>& scenes);

}  // namespace cps
