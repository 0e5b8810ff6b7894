#pragma once

#include <map>
#include <tuple>

#include "scenes/gltf/document/document.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// Turns the materials and textures that meshes really use into the scene's, each once.
struct MaterialTable {
  Document& document;
  Scene& scene;
  std::map<int, int> materials = {};  ///< glTF material (−1: the default one) → scene's
  std::map<std::tuple<int, int, bool>, int> textures = {};  ///< glTF image, sampler, is colour → scene's
};

/// The scene's index of a glTF material, −1 meaning glTF's default material. An image that serves as colour
/// here and as data there becomes two textures.
int material_index(MaterialTable& table, int gltf_material, const std::string& where);

}  // namespace cps::gltf
