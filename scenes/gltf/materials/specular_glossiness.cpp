#include "scenes/gltf/materials/specular_glossiness.h"

#include <cmath>

namespace cps::gltf {

int roughness_texture(MaterialTable& table, int texture, float glossiness) {
  const auto [found, is_new] = table.roughness_textures.try_emplace({texture, glossiness}, -1);
  if (!is_new) return found->second;
  const Texture& from = table.scene.textures[texture];
  reserve_memory(table.document, from.name, from.rgba.size(), 1);
  Texture roughness = from;
  for (std::size_t i = 0; i < roughness.rgba.size(); i += 4) {
    const float gloss = glossiness * static_cast<float>(from.rgba[i + 3]);
    roughness.rgba[i + 1] = static_cast<std::uint8_t>(std::lround(255 - gloss));
    roughness.rgba[i + 2] = 0;
  }
  table.scene.textures.push_back(std::move(roughness));
  return found->second = static_cast<int>(table.scene.textures.size()) - 1;
}

}  // namespace cps::gltf
