#include "scenes/gltf/document/tinygltf_gaps.h"

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

std::vector<std::string> fill_tinygltf_gaps(nlohmann::json& root) {
  std::vector<std::string> warnings;
  const auto objects = [&](const char* list, auto change) {
    if (!root.contains(list) || !root[list].is_array()) return;
    for (std::size_t i = 0; i < root[list].size(); ++i)
      if (root[list][i].is_object()) change(root[list][i], element(list, i));
  };
  if (root.contains("animations") && !root["animations"].empty())
    warnings.emplace_back("animations are not played, the rest pose is drawn");
  root.erase("animations");
  objects("skins", [](nlohmann::json& skin, const std::string&) {
    if (!skin.contains("inverseBindMatrices")) skin["inverseBindMatrices"] = -1;
  });
  objects("buffers", [&](nlohmann::json& buffer, const std::string& name) {
    if (buffer.value("byteLength", std::size_t{1}) != 0) return;
    warnings.push_back(name + " is empty and left out");
    buffer = {{"byteLength", 1}, {"uri", "data:application/octet-stream;base64,AA=="}};
  });
  return warnings;
}

}  // namespace cps::gltf
