#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sampler/plan/scene_plan.h"
#include "scenes/scene.h"

namespace cps {

/// Throws std::runtime_error in one line when the file of a scene that is no procedural city is missing.
void require_given_files(const std::vector<PlannedScene>& scenes);

/// Makes the missing files of procedural cities. Processes that do so at the same time share the work: a city
/// is made by the process that holds its lock in `lock_folder`. Throws as require_given_files() does.
void make_scene_files(const std::vector<PlannedScene>& scenes, const std::filesystem::path& lock_folder);

/// The scene as it is rendered: in metres, with the car's bonnet if the recipe asks for it. Throws as
/// import_gltf() does.
Scene load_scene(const PlannedScene& planned, const Recipe& recipe);

}  // namespace cps
