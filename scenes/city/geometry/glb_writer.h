#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/city/geometry/mesh.h"
#include "scenes/city/image.h"

namespace cps::city {

/// A glTF metallic-roughness material. Colours are linear; texture −1 means none.
struct MaterialDescription {
  std::string name;
  std::array<double, 3> base_color = {1, 1, 1};
  double metallic = 0, roughness = 1;
  int base_color_texture = -1, metallic_roughness_texture = -1, normal_texture = -1;
  bool alpha_mask = false, double_sided = false;
  std::array<double, 3> emissive = {0, 0, 0};
  double transmission = 0;  ///< share of light through a thin wall (KHR_materials_transmission)
};

/// A mesh's pose: scaled uniformly, turned by `heading_rad` about the vertical, then tilted so that the
/// vertical becomes `up` (unit), at `position` in glTF's frame.
struct Placement {
  Vec3 position = Vec3::Zero();
  double heading_rad = 0, scale = 1;
  Vec3 up = {0, 1, 0};
};

/// Collects a glTF 2.0 asset and writes it as one .glb file. Things appear in the file in the order of the
/// calls, so equal calls give equal bytes.
class GlbWriter {
 public:
  /// Adds a texture, stored as PNG; returns its index.
  int add_texture(const std::string& name, const Image& image);
  MaterialId add_material(const MaterialDescription& material);
  /// Adds a mesh, which add_node places; returns its index.
  int add_mesh(const Mesh& mesh);
  /// Adds a mesh that shares another's vertices but has one material replaced; returns its index.
  int add_variant(int mesh, const std::string& name, MaterialId from, MaterialId to);
  void add_node(const std::string& name, int mesh, const Placement& placement = {});

  /// Writes the file by rename and returns its size in bytes. Throws std::runtime_error naming file and
  /// cause.
  std::size_t write(const std::filesystem::path& file, const nlohmann::ordered_json& scene_extras) const;

  std::size_t stored_triangles() const { return triangles; }
  std::size_t instanced_triangles() const { return placed_triangles; }

 private:
  int add_view(const void* data, std::size_t size, int target, int stride);

  nlohmann::ordered_json images = nlohmann::ordered_json::array(), textures = images, materials = images,
                         meshes = images, nodes = images, accessors = images, views = images;
  std::vector<std::uint8_t> binary;
  std::vector<std::size_t> mesh_triangles;
  std::size_t triangles = 0, placed_triangles = 0;
};

}  // namespace cps::city
