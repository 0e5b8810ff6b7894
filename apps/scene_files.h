#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sampler/recipe.h"

namespace cps {

/// The recipe's scenes as files, then its procedural cities as files in `city_folder`, which are made here if
/// they are not there yet. Throws std::runtime_error when a scene is missing.
std::vector<std::filesystem::path> scene_files(const Recipe& recipe,
                                               const std::filesystem::path& city_folder);

/// SHA-256 of each file.
std::vector<std::string> scene_hashes(const std::vector<std::filesystem::path>& files);

/// What a job is: another recipe, rig or drive (`wanted`, as text), another scene or another program gives
/// another fingerprint.
std::string job_fingerprint(const std::string& wanted, const std::vector<std::string>& scene_sha256);

}  // namespace cps
