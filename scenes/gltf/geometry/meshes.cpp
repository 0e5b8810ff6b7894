#include "scenes/gltf/geometry/meshes.h"

#include "scenes/gltf/document/draco.h"

namespace cps::gltf {

std::vector<int> add_meshes(MeshTable& table, int gltf_mesh, const RestPose& pose) {
  std::vector<int> added;
  const tinygltf::Mesh& from = table.document.model.meshes[gltf_mesh];
  for (std::size_t i = 0; i < from.primitives.size(); ++i) {
    const std::string where = element("meshes", gltf_mesh) + "." + element("primitives", i);
    const tinygltf::Primitive primitive = without_draco(table.document, from.primitives[i], where);
    Mesh mesh = make_mesh(table.materials, primitive, pose, where);
    if (mesh.triangles.empty()) continue;
    mesh.name = from.name;
    table.scene.meshes.push_back(std::move(mesh));
    added.push_back(static_cast<int>(table.scene.meshes.size()) - 1);
  }
  return added;
}

const std::vector<int>& shared_meshes(MeshTable& table, int gltf_mesh, const std::vector<double>& weights) {
  const auto [found, is_new] = table.shared.try_emplace({gltf_mesh, weights});
  if (is_new) found->second = add_meshes(table, gltf_mesh, {weights, {}});
  return found->second;
}

}  // namespace cps::gltf
