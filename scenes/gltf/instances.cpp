#include "scenes/gltf/instances.h"

#include <cmath>
#include <numeric>

#include "scenes/gltf/document/accessors.h"
#include "scenes/gltf/geometry/flattened.h"
#include "scenes/gltf/geometry/morphs.h"
#include "scenes/gltf/geometry/skins.h"

namespace cps::gltf {
namespace {

/// Whether normals can be transformed: a transform that flattens the mesh has no inverse.
bool is_invertible(const Eigen::Affine3f& transform) {
  const Eigen::Matrix3f m = transform.linear();
  const float size = m.col(0).norm() * m.col(1).norm() * m.col(2).norm();
  return transform.matrix().allFinite() && size > 0 && std::abs(m.determinant()) > 1e-6f * size;
}

template <int N>
std::vector<Eigen::Matrix<float, N, 1>> read_instancing(Document& document, const tinygltf::Value& attributes,
                                                        const char* name, const std::string& where) {
  if (!attributes.Has(name)) return {};
  const tinygltf::Value& accessor = attributes.Get(name);
  const Elements from =
      elements(document, accessor.IsInt() ? accessor.GetNumberAsInt() : -1, where + "." + name);
  reserve_memory(document, where, from.count, sizeof(std::uint32_t));
  std::vector<std::uint32_t> all(from.count);
  std::iota(all.begin(), all.end(), 0u);
  return read_vectors<N>(document, from, where + "." + name, all);
}

/// The transforms of EXT_mesh_gpu_instancing, in the node's frame; the identity alone without it.
std::vector<Eigen::Affine3d> repetitions(Document& document, const tinygltf::Node& node,
                                         const std::string& where) {
  const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
  if (extension == node.extensions.end()) return {Eigen::Affine3d::Identity()};
  const std::string name = where + ".EXT_mesh_gpu_instancing";
  if (!extension->second.Has("attributes")) refuse(document, name, "has no attributes");
  const tinygltf::Value& attributes = extension->second.Get("attributes");
  const auto translations = read_instancing<3>(document, attributes, "TRANSLATION", name);
  const auto rotations = read_instancing<4>(document, attributes, "ROTATION", name);
  const auto scales = read_instancing<3>(document, attributes, "SCALE", name);
  const std::size_t count = std::max({translations.size(), rotations.size(), scales.size()});
  for (const std::size_t size : {translations.size(), rotations.size(), scales.size()})
    if (count == 0 || (size != 0 && size != count)) refuse(document, name, "its attributes differ in count");
  reserve_memory(document, name, count, sizeof(Eigen::Affine3d));
  std::vector<Eigen::Affine3d> transforms(count, Eigen::Affine3d::Identity());
  for (std::size_t i = 0; i < count; ++i) {
    if (!translations.empty()) transforms[i].translate(translations[i].cast<double>());
    if (!rotations.empty())
      transforms[i].rotate(Eigen::Quaterniond(rotations[i].cast<double>()).normalized());
    if (!scales.empty()) transforms[i].scale(scales[i].cast<double>());
  }
  return transforms;
}

/// Places the parts of one mesh in the world as one object; none if there are no parts.
void add_object(MeshTable& meshes, const std::string& name, const std::vector<int>& parts,
                const Eigen::Affine3f& world_from_mesh, const std::string& where) {
  if (parts.empty()) return;
  Scene& scene = meshes.scene;
  reserve_memory(meshes.document, where, 1, sizeof(std::string) + name.size());
  const int object = static_cast<int>(scene.objects.size());
  scene.objects.push_back(name);
  for (const int mesh : parts)
    scene.instances.push_back({.mesh = mesh, .world_from_mesh = world_from_mesh, .object = object});
}

/// Adds meshes whose transform has no inverse, each moved into the world.
void add_flattened(MeshTable& meshes, const std::string& name, const std::vector<int>& parts,
                   const Eigen::Affine3f& world_from_mesh, const std::string& where) {
  std::vector<int> drawn;
  for (const int part : parts) {
    const Mesh& mesh = meshes.scene.meshes[part];
    reserve_memory(meshes.document, where, mesh.positions.size() + mesh.triangles.size(),
                   sizeof(Eigen::Vector4f));
    Mesh flat = flattened(mesh, world_from_mesh);
    if (flat.triangles.empty()) continue;
    drawn.push_back(static_cast<int>(meshes.scene.meshes.size()));
    meshes.scene.meshes.push_back(std::move(flat));
  }
  if (drawn.empty()) warn(meshes.document, where + ": its scale is 0 along two axes, not drawn");
  add_object(meshes, name, drawn, Eigen::Affine3f::Identity(), where);
}

void add_instances(MeshTable& meshes, const PlacedNode& placed, const std::string& where) {
  Document& document = meshes.document;
  const tinygltf::Node& node = document.model.nodes[placed.node];
  const std::vector<double> weights = rest_weights(document, node);
  for (const Eigen::Affine3d& node_from_mesh : repetitions(document, node, where)) {
    const Eigen::Affine3f world_from_mesh = (placed.world_from_node * node_from_mesh).cast<float>();
    if (!world_from_mesh.matrix().allFinite()) {
      warn(document, where + ": its transform is not finite, not drawn");
      continue;
    }
    const std::vector<int>& parts = shared_meshes(meshes, node.mesh, weights);
    reserve_memory(document, where, parts.size(), sizeof(Instance));
    if (is_invertible(world_from_mesh))
      add_object(meshes, node.name, parts, world_from_mesh, where);
    else
      add_flattened(meshes, node.name, parts, world_from_mesh, where);
  }
}

}  // namespace

void add_instances(MeshTable& meshes, std::span<const PlacedNode> placed) {
  Document& document = meshes.document;
  for (const PlacedNode& place : placed) {
    const tinygltf::Node& node = document.model.nodes[place.node];
    if (node.mesh == -1 || !place.is_visible) continue;
    const std::string where = element("nodes", place.node);
    if (!in_range(node.mesh, document.model.meshes))
      refuse(document, where + ".mesh", std::to_string(node.mesh) + " does not exist");
    if (node.skin == -1) {
      add_instances(meshes, place, where);
    } else {  // a skinned mesh is placed by its joints, not by its node
      const RestPose pose{rest_weights(document, node), joint_transforms(document, node.skin, placed)};
      add_object(meshes, node.name, add_meshes(meshes, node.mesh, pose), Eigen::Affine3f::Identity(), where);
    }
  }
}

}  // namespace cps::gltf
