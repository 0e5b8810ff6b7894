#include "scenes/gltf/geometry/primitives.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "scenes/gltf/geometry/attributes.h"
#include "scenes/gltf/geometry/morphs.h"
#include "scenes/gltf/geometry/normals.h"
#include "scenes/gltf/geometry/skins.h"
#include "scenes/gltf/geometry/tangents.h"
#include "scenes/gltf/geometry/triangles.h"

namespace cps::gltf {
namespace {

std::vector<std::uint32_t> read_corners(Document& document, const tinygltf::Primitive& primitive,
                                        std::size_t vertex_count, const std::string& where) {
  std::vector<std::uint32_t> indices;
  if (primitive.indices != -1) {
    indices = read_indices(document, primitive.indices, where + ".indices");
    for (const std::uint32_t index : indices)
      if (index >= vertex_count)
        refuse(document, where + ".indices",
               "vertex " + std::to_string(index) + " of " + std::to_string(vertex_count) + " does not exist");
  } else {
    reserve_memory(document, where, vertex_count, sizeof(std::uint32_t));
    indices.resize(vertex_count);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  return triangle_corners(document, primitive.mode, indices, where);
}

/// Gives every vertex the texture coordinates that its material uses, zeros if the file has none.
void complete_uv(PrimitiveReader& reader, const Material& material, Mesh& mesh) {
  const auto needs = [&](int set) {
    for (const TextureSlot* slot : texture_slots(material))
      if (slot->texture != -1 && slot->uv_set == set) return true;
    return false;
  };
  if ((mesh.uv0.empty() && needs(0)) || (mesh.uv1.empty() && needs(1)))
    warn(reader.document,
         reader.where + ": its material's textures need texture coordinates that it does not have");
  if (mesh.uv0.empty()) mesh.uv0.assign(mesh.positions.size(), Eigen::Vector2f::Zero());
  if (mesh.uv1.empty() && needs(1)) mesh.uv1.assign(mesh.positions.size(), Eigen::Vector2f::Zero());
}

/// Makes the normals and tangents that are missing or broken.
void complete_frames(PrimitiveReader& reader, const Material& material, Mesh& mesh) {
  if (mesh.normals.empty()) {
    reserve_memory(reader.document, reader.where, mesh.triangles.size(), 3 * 64);
    make_flat_normals(mesh);
  } else if (const std::size_t repaired = repair_normals(mesh)) {
    warn(reader.document,
         reader.where + ".NORMAL: " + std::to_string(repaired) + " are zero or not finite, made anew");
  }
  const TextureSlot& normal_map =
      material.normal_texture.texture != -1 ? material.normal_texture : material.clearcoat_normal_texture;
  if (normal_map.texture == -1) {
    mesh.tangents.clear();  // only normal maps use them
    return;
  }
  if (!normalize_tangents(mesh)) {
    warn(reader.document, reader.where + ".TANGENT: not valid, made anew");
    mesh.tangents.clear();
  }
  if (mesh.tangents.empty()) make_tangents(mesh, normal_map);
}

/// Deforms the mesh by its joints. Without JOINTS_0 and WEIGHTS_0 it only warns; triangles with a vertex
/// without weights have no place and are left out.
void apply_skin(PrimitiveReader& reader, std::span<const Eigen::Affine3f> joint_transforms, Mesh& mesh) {
  const auto joints = read_finite_attribute<4>(reader, "JOINTS_0");
  auto weights = read_finite_attribute<4>(reader, "WEIGHTS_0");
  if (joints.empty() || weights.empty()) {
    warn(reader.document, reader.where + ": has a skin but no JOINTS_0 and WEIGHTS_0, drawn as it is");
    return;
  }
  std::set<int> weightless;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const float count = static_cast<float>(joint_transforms.size());
    const bool valid =
        joints[i].minCoeff() >= 0 && joints[i].maxCoeff() < count && weights[i].minCoeff() >= 0;
    if (!valid)
      refuse(
          reader.document, reader.where + ".JOINTS_0",
          "vertex " + std::to_string(reader.vertices[i]) + " has no joint of its skin or a weight below 0");
    if (weights[i].sum() > 0) continue;
    weightless.insert(static_cast<int>(i));
    weights[i].x() = 1;
  }
  if (!weightless.empty()) {
    warn(reader.document, reader.where + ".WEIGHTS_0: " + std::to_string(weightless.size()) +
                              " vertices have no weight, their triangles are not drawn");
    std::erase_if(mesh.triangles, [&](const Eigen::Vector3i& triangle) {
      return std::ranges::any_of(triangle, [&](int vertex) { return weightless.contains(vertex); });
    });
  }
  blend_to_joints(mesh, joints, weights, joint_transforms);
}

/// Refuses positions and coordinates that morph weights or joints made too large for a float.
void check_finite(const PrimitiveReader& reader, const Mesh& mesh) {
  const auto check = [&](const auto& values, const std::string& name) {
    for (const auto& value : values)
      if (!value.allFinite())
        refuse(reader.document, reader.where + "." + name, "is not finite in the rest pose");
  };
  check(mesh.positions, "POSITION");
  check(mesh.uv0, reader.uv_names[0]);
  check(mesh.uv1, reader.uv_names[1]);
}

bool is_empty(const Document& document, int accessor) {
  return in_range(accessor, document.model.accessors) && document.model.accessors[accessor].count == 0;
}

}  // namespace

Mesh make_mesh(MaterialTable& materials, const tinygltf::Primitive& primitive, const RestPose& pose,
               const std::string& where) {
  Document& document = materials.document;
  Mesh mesh;
  if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    refuse(document, where + ".mode", std::to_string(primitive.mode) + " is not one of glTF's");
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    warn(document, where + ": points and lines are not drawn");
    return mesh;
  }
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) {
    warn(document, where + ": has no POSITION and is not drawn");
    return mesh;
  }
  if (is_empty(document, position->second) ||
      (primitive.indices != -1 && is_empty(document, primitive.indices))) {
    warn(document, where + ": is empty and not drawn");
    return mesh;
  }
  const std::size_t vertex_count = elements(document, position->second, where + ".POSITION").count;
  CompactTriangles compacted =
      compact(document, read_corners(document, primitive, vertex_count, where), where);
  PrimitiveReader reader{document, primitive, where, std::move(compacted.vertices), vertex_count};
  mesh.triangles = std::move(compacted.triangles);
  mesh.positions = read_finite_attribute<3>(reader, "POSITION");
  mesh.normals = read_attribute<3>(reader, "NORMAL");
  mesh.tangents = read_attribute<4>(reader, "TANGENT");
  mesh.material = material_index(materials, primitive.material, where);
  for (int i : {0, 1}) reader.uv_names[i] = "TEXCOORD_" + std::to_string(materials.uv_sets[mesh.material][i]);
  mesh.uv0 = read_finite_attribute<2>(reader, reader.uv_names[0]);
  mesh.uv1 = read_finite_attribute<2>(reader, reader.uv_names[1]);
  mesh.colors = read_colors(reader);
  apply_morph_targets(reader, pose.weights, mesh);
  if (!pose.joint_transforms.empty()) apply_skin(reader, pose.joint_transforms, mesh);
  check_finite(reader, mesh);
  const Material& material = materials.scene.materials[mesh.material];
  complete_uv(reader, material, mesh);
  complete_frames(reader, material, mesh);
  return mesh;
}

}  // namespace cps::gltf
