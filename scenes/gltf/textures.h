#pragma once

#include <string>

#include "scenes/gltf/materials.h"

namespace cps::gltf {

/// The slot for a textureInfo of a material: its texture is decoded on first use; the coordinates' set and
/// transform come from the info and its KHR_texture_transform. `index` −1 means no texture. `srgb`: colour or
/// data.
TextureSlot texture_slot(MaterialTable& table, int index, int uv_set,
                         const tinygltf::ExtensionMap& extensions, bool srgb, const std::string& where);

/// The numbers in extension property `key` (an array of `size`, or one number for size 1), or `missing`.
std::vector<double> extension_numbers(const Document& document, const tinygltf::Value& extension,
                                      const char* key, std::vector<double> missing, const std::string& where);

}  // namespace cps::gltf
