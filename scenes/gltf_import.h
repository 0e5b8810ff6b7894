#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace cps {

/// Reads a .glb or .gltf file (glTF 2.0): triangles, strips and fans with u8/u16/u32 indices or none, sparse,
/// quantised and Draco-compressed data, node hierarchies, shared and GPU-instanced meshes, skins in rest
/// pose, metallic-roughness materials and their extensions for glass, clear coats, specular and unlit
/// colours, lamps (KHR_lights_punctual), textures from buffers, files and data URIs (PNG, JPEG, WebP, decoded
/// by OpenImageIO). Missing normals are made, and missing tangents where a material has a normal map. Lanes
/// come from the scene's `extras.cps_lanes`:
/// `[{"street": "A", "width_m": 3.25, "points": [[x, y, z], …]}, …]`.
/// What can be left out without changing the shape of things (extensions of materials, animations, …) is
/// noted in `warnings`, a line each. Throws std::runtime_error with one line (file, what, fix) for what is
/// broken or not supported; nothing is guessed.
///
/// A few bytes of glTF can ask for terabytes: what would need more than `max_decoded_bytes` of vertices,
/// triangles and texels, or names as much in other files, is refused before it is read or allocated.
Scene import_gltf(const std::filesystem::path& file, std::vector<std::string>* warnings = nullptr,
                  std::size_t max_decoded_bytes = std::size_t{12} << 30);

}  // namespace cps
