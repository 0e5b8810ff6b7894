#pragma once

#include <string>

#include "scenes/gltf/materials/materials.h"

namespace cps::gltf {

/// Reads a material's extensions into `material`: KHR_materials_ior, _specular, _clearcoat, _transmission,
/// _unlit and _emissive_strength (which multiplies `material.emissive`).
void read_material_extensions(MaterialTable& table, const tinygltf::ExtensionMap& extensions,
                              const std::string& where, Material& material);

}  // namespace cps::gltf
