#include "scenes/gltf/meshes.h"

#include <cmath>
#include <numeric>

#include "scenes/gltf/accessors.h"
#include "scenes/gltf/draco.h"
#include "scenes/gltf/skins.h"
#include "scenes/gltf/triangles.h"
#include "scenes/gltf/vertex_frames.h"

namespace cps::gltf {
namespace {

/// One primitive being read: which accessor elements become the mesh's vertices.
struct PrimitiveReader {
  Document& document;
  const tinygltf::Primitive& primitive;
  std::string where;
  std::vector<std::uint32_t> vertices;
  std::size_t vertex_count;  ///< before unused ones were dropped
};

/// An attribute's vectors for the mesh's vertices, empty without it; it must have as many elements as
/// POSITION.
template <int N>
std::vector<Eigen::Matrix<float, N, 1>> read_attribute(PrimitiveReader& reader, const char* name) {
  const auto found = reader.primitive.attributes.find(name);
  if (found == reader.primitive.attributes.end()) return {};
  const std::string where = reader.where + "." + name;
  const Elements from = elements(reader.document, found->second, where);
  if (from.count != reader.vertex_count)
    refuse(reader.document, where,
           "has " + std::to_string(from.count) + " elements, POSITION has " +
               std::to_string(reader.vertex_count));
  return read_vectors<N>(reader.document, from, where, reader.vertices);
}

template <int N>
std::vector<Eigen::Matrix<float, N, 1>> read_finite_attribute(PrimitiveReader& reader, const char* name) {
  auto vectors = read_attribute<N>(reader, name);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    if (!vectors[i].allFinite())
      refuse(reader.document, reader.where + "." + name,
             "element " + std::to_string(reader.vertices[i]) + " is not finite");
  return vectors;
}

/// RGB or RGBA; linear already.
std::vector<Eigen::Vector4f> read_colors(PrimitiveReader& reader) {
  const std::vector<tinygltf::Accessor>& accessors = reader.document.model.accessors;
  const auto found = reader.primitive.attributes.find("COLOR_0");
  if (found == reader.primitive.attributes.end() || !in_range(found->second, accessors))
    return read_attribute<4>(reader, "COLOR_0");
  const tinygltf::Accessor& colors = accessors[found->second];
  if (colors.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT && !colors.normalized)
    refuse(reader.document, reader.where + ".COLOR_0", "integer colours must be normalized");
  if (colors.type != TINYGLTF_TYPE_VEC3) return read_finite_attribute<4>(reader, "COLOR_0");
  std::vector<Eigen::Vector4f> with_alpha;
  for (const Eigen::Vector3f& color : read_finite_attribute<3>(reader, "COLOR_0"))
    with_alpha.emplace_back(color.x(), color.y(), color.z(), 1.0f);
  return with_alpha;
}

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

/// Every vertex has the coordinates its material asks for, zeros if need be.
void complete_uv(PrimitiveReader& reader, const Material& material, Mesh& mesh) {
  const auto needs = [&](int set) {
    for (const TextureSlot* slot : {&material.base_color_texture, &material.metallic_roughness_texture,
                                    &material.normal_texture, &material.emissive_texture})
      if (slot->texture != -1 && slot->uv_set == set) return true;
    return false;
  };
  if ((mesh.uv0.empty() && needs(0)) || (mesh.uv1.empty() && needs(1)))
    warn(reader.document,
         reader.where + ": its material's textures need texture coordinates that it does not have");
  if (mesh.uv0.empty()) mesh.uv0.assign(mesh.positions.size(), Eigen::Vector2f::Zero());
  if (mesh.uv1.empty() && needs(1)) mesh.uv1.assign(mesh.positions.size(), Eigen::Vector2f::Zero());
}

/// Normals and tangents, made where the file has none or broken ones.
void complete_frames(PrimitiveReader& reader, const Material& material, Mesh& mesh) {
  if (mesh.normals.empty()) {
    reserve_memory(reader.document, reader.where, mesh.triangles.size(), 3 * 64);
    make_flat_normals(mesh);
  } else if (const std::size_t repaired = repair_normals(mesh)) {
    warn(reader.document,
         reader.where + ".NORMAL: " + std::to_string(repaired) + " without direction, made anew");
  }
  if (material.normal_texture.texture == -1) {
    mesh.tangents.clear();  // of no use
    return;
  }
  if (!normalize_tangents(mesh)) {
    warn(reader.document, reader.where + ".TANGENT: not valid, made anew");
    mesh.tangents.clear();
  }
  if (mesh.tangents.empty()) make_tangents(mesh, material.normal_texture);
}

/// Bends the mesh to its joints; without JOINTS_0 and WEIGHTS_0 it stays as it is.
void apply_skin(PrimitiveReader& reader, std::span<const Eigen::Affine3f> joint_transforms, Mesh& mesh) {
  const auto joints = read_finite_attribute<4>(reader, "JOINTS_0");
  const auto weights = read_finite_attribute<4>(reader, "WEIGHTS_0");
  if (joints.empty() || weights.empty()) {
    warn(reader.document, reader.where + ": has a skin but no JOINTS_0 and WEIGHTS_0, drawn as it is");
    return;
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const float count = static_cast<float>(joint_transforms.size());
    const bool valid = joints[i].minCoeff() >= 0 && joints[i].maxCoeff() < count &&
                       weights[i].minCoeff() >= 0 && weights[i].sum() > 0;
    if (!valid)
      refuse(reader.document, reader.where + ".JOINTS_0",
             "vertex " + std::to_string(reader.vertices[i]) + " has no joint of its skin or no weight");
  }
  blend_to_joints(mesh, joints, weights, joint_transforms);
}

/// The scene's mesh for one primitive, without triangles where it has none.
Mesh make_mesh(MeshTable& table, const tinygltf::Primitive& primitive,
               std::span<const Eigen::Affine3f> joint_transforms, const std::string& where) {
  Document& document = table.document;
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
  const std::size_t vertex_count = elements(document, position->second, where + ".POSITION").count;
  CompactTriangles compacted =
      compact(document, read_corners(document, primitive, vertex_count, where), where);
  PrimitiveReader reader{document, primitive, where, std::move(compacted.vertices), vertex_count};
  mesh.triangles = std::move(compacted.triangles);
  mesh.positions = read_finite_attribute<3>(reader, "POSITION");
  mesh.normals = read_attribute<3>(reader, "NORMAL");
  mesh.tangents = read_attribute<4>(reader, "TANGENT");
  mesh.uv0 = read_finite_attribute<2>(reader, "TEXCOORD_0");
  mesh.uv1 = read_finite_attribute<2>(reader, "TEXCOORD_1");
  mesh.colors = read_colors(reader);
  if (!joint_transforms.empty()) apply_skin(reader, joint_transforms, mesh);
  mesh.material = material_index(table.materials, primitive.material, where);
  const Material& material = table.scene.materials[mesh.material];
  complete_uv(reader, material, mesh);
  complete_frames(reader, material, mesh);
  if (!primitive.targets.empty()) warn(document, "morph targets are not applied");
  return mesh;
}

std::vector<int> add_meshes(MeshTable& table, int gltf_mesh,
                            std::span<const Eigen::Affine3f> joint_transforms) {
  std::vector<int> added;
  const tinygltf::Mesh& from = table.document.model.meshes[gltf_mesh];
  for (std::size_t i = 0; i < from.primitives.size(); ++i) {
    const std::string where = element("meshes", gltf_mesh) + "." + element("primitives", i);
    const tinygltf::Primitive primitive = without_draco(table.document, from.primitives[i], where);
    Mesh mesh = make_mesh(table, primitive, joint_transforms, where);
    if (mesh.triangles.empty()) continue;
    mesh.name = from.name;
    table.scene.meshes.push_back(std::move(mesh));
    added.push_back(static_cast<int>(table.scene.meshes.size()) - 1);
  }
  return added;
}

}  // namespace

const std::vector<int>& mesh_indices(MeshTable& table, int gltf_mesh) {
  const auto [found, is_new] = table.meshes.try_emplace(gltf_mesh);
  if (is_new) found->second = add_meshes(table, gltf_mesh, {});
  return found->second;
}

std::vector<int> skinned_mesh(MeshTable& table, int gltf_mesh,
                              std::span<const Eigen::Affine3f> joint_transforms) {
  return add_meshes(table, gltf_mesh, joint_transforms);
}

}  // namespace cps::gltf
