#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cps::gltf {

/// Changes the JSON of valid files that tinygltf would refuse: takes animations out (they are not played),
/// and gives skins without inverse bind matrices the index −1. Empty buffers, which are not valid, get a
/// byte. Returns a warning for each thing left out.
std::vector<std::string> fill_tinygltf_gaps(nlohmann::json& root);

}  // namespace cps::gltf
