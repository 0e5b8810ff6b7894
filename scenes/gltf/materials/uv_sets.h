#pragma once

#include <array>
#include <string>

#include "scenes/gltf/document/document.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// The glTF sets of texture coordinates that become a mesh's uv0 and uv1: 0 and 1, unless the material's
/// textures use a higher one. Changes the slots' `uv_set` from glTF's number to 0 or 1. A third set of one
/// material is replaced by its first, with a warning.
std::array<int, 2> choose_uv_sets(Document& document, Material& material, const std::string& where);

}  // namespace cps::gltf
