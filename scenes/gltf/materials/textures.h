#pragma once

#include <string>

#include "scenes/gltf/materials/materials.h"

namespace cps::gltf {

/// The slot for a textureInfo of a material: its texture is decoded on first use; the coordinates' set and
/// transform come from the info and its KHR_texture_transform. `index` −1 means no texture. `srgb`: colour or
/// data.
TextureSlot texture_slot(MaterialTable& table, int index, int uv_set,
                         const tinygltf::ExtensionMap& extensions, bool srgb, const std::string& where);

/// The same for a textureInfo that stands under `key` in a material's extension.
TextureSlot extension_texture(MaterialTable& table, const tinygltf::Value& extension, const char* key,
                              bool srgb, const std::string& where);

}  // namespace cps::gltf
