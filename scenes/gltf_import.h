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
/// colours, lights (KHR_lights_punctual), textures from buffers, files and data URIs (PNG, JPEG, WebP,
/// decoded by OpenImageIO). Makes missing normals, and missing tangents where a material has a normal map.
/// Reads lanes from the scene's `extras.cps_lanes`: `[{"street": "A", "width_m": 3.25, "points": [[x, y, z],
/// …]}, …]`. `import_warnings` gets a line for each thing ignored (material extensions, animations, …)
/// or left out because it is broken while the rest is sound. Throws std::runtime_error with one line (file,
/// what, fix) if the file is broken or needs something unsupported; guesses nothing.
///
/// A few bytes of glTF can ask for terabytes. So a file that would need more than `max_decoded_bytes` of
/// vertices, triangles and texels, or as much in external files, is refused before anything is allocated.
Scene import_gltf(const std::filesystem::path& file, std::size_t max_decoded_bytes = std::size_t{12} << 30);

}  // namespace cps
