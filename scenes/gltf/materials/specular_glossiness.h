#pragma once

#include "scenes/gltf/materials/materials.h"

namespace cps::gltf {

/// The scene's texture of roughness (green: 1 − glossiness · alpha) and no metal (blue) made from `texture`,
/// whose alpha is KHR_materials_pbrSpecularGlossiness's gloss. Made once for each texture and glossiness.
int roughness_texture(MaterialTable& table, int texture, float glossiness);

}  // namespace cps::gltf
