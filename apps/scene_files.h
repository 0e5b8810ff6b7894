#pragma once

#include <string>
#include <vector>

#include "sampler/scene_plan.h"
#include "scenes/scene.h"

namespace cps {

/// Makes the files of procedural cities that are not there yet. Throws std::runtime_error when another
/// scene's file is missing.
void make_scene_files(const std::vector<PlannedScene>& scenes);

/// The scene as its views see it: in metres, with the car's bonnet where the recipe wants it.
Scene load_scene(const PlannedScene& planned, const Recipe& recipe);

/// SHA-256 of each file.
std::vector<std::string> scene_hashes(const std::vector<PlannedScene>& scenes);

/// What a job is: another recipe, rig or drive (`wanted`, as text), another scene or another program gives
/// another fingerprint.
std::string job_fingerprint(const std::string& wanted, const std::vector<std::string>& scene_sha256);

}  // namespace cps
