#pragma once

#include <array>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "scenes/gltf/document/document.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// Makes the scene's materials and textures from those that meshes use, each once.
struct MaterialTable {
  Document& document;
  Scene& scene;
  std::map<int, int> materials = {};  ///< glTF material (−1: default) → the scene's
  /// (glTF image, sampler, is colour) → the scene's
  std::map<std::tuple<int, int, bool>, int> textures = {};
  std::map<std::pair<int, float>, int> roughness_textures = {};  ///< (texture, glossiness) → the scene's
  /// Of each material of the scene: the glTF sets of texture coordinates that become uv0 and uv1.
  std::vector<std::array<int, 2>> uv_sets = {};
};

/// The scene's index of a glTF material (−1: glTF's default material). An image used both as colour and as
/// data becomes two textures.
int material_index(MaterialTable& table, int gltf_material, const std::string& where);

}  // namespace cps::gltf
