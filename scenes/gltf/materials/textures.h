#pragma once

#include <string>

#include "scenes/gltf/materials/materials.h"

namespace cps::gltf {

/// The slot for a textureInfo. `index` is the glTF texture (−1: none), decoded on first use; `uv_set` and
/// `extensions` (KHR_texture_transform) give the coordinates. `srgb`: the texture holds colour, not data.
TextureSlot texture_slot(MaterialTable& table, int index, int uv_set,
                         const tinygltf::ExtensionMap& extensions, bool srgb, const std::string& where);

/// The slot for the textureInfo in property `key` of a material extension.
TextureSlot extension_texture(MaterialTable& table, const tinygltf::Value& extension, const char* key,
                              bool srgb, const std::string& where);

}  // namespace cps::gltf
