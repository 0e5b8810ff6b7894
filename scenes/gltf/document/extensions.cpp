#include "scenes/gltf/document/extensions.h"

#include <algorithm>
#include <array>

namespace cps::gltf {
namespace {

bool is_supported(const std::string& extension) {
  constexpr std::array names = {"EXT_mesh_gpu_instancing",
                                "EXT_meshopt_compression",
                                "EXT_texture_webp",
                                "KHR_draco_mesh_compression",
                                "KHR_lights_punctual",
                                "KHR_materials_clearcoat",
                                "KHR_materials_emissive_strength",
                                "KHR_materials_ior",
                                "KHR_materials_specular",
                                "KHR_materials_transmission",
                                "KHR_materials_pbrSpecularGlossiness",
                                "KHR_materials_unlit",
                                "KHR_mesh_quantization",
                                "KHR_node_visibility",
                                "KHR_texture_transform"};
  return std::find(names.begin(), names.end(), extension) != names.end();
}

}  // namespace

void check_required_extensions(const std::filesystem::path& file, const nlohmann::json& root) {
  const auto required = root.find("extensionsRequired");
  if (required == root.end()) return;
  if (!required->is_array()) refuse(file, "extensionsRequired", "must be an array");
  for (const nlohmann::json& name : *required) {
    if (!name.is_string()) refuse(file, "extensionsRequired", "must hold names");
    if (!is_supported(name))
      refuse(file, "extensionsRequired",
             name.get<std::string>() + " is not supported: export the file again without it");
  }
}

void warn_of_ignored_extensions(Document& document) {
  for (const std::string& name : document.model.extensionsUsed)
    if (!is_supported(name)) warn(document, name + " is not supported and left out");
}

}  // namespace cps::gltf
