#include "scenes/gltf/document/nodes.h"

#include <algorithm>

namespace cps::gltf {
namespace {

Eigen::Affine3d local_transform(const Document& document, const tinygltf::Node& node,
                                const std::string& where) {
  const auto has_size = [&](const std::vector<double>& numbers, std::size_t size, const char* name) {
    if (!numbers.empty() && numbers.size() != size)
      refuse(document, where + "." + name, "must be " + std::to_string(size) + " numbers");
    return !numbers.empty();
  };
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (has_size(node.matrix, 16, "matrix")) {
    transform.matrix() =
        Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());  // column by column, as Eigen's
    if (transform.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
      refuse(document, where + ".matrix", "its last row must be 0 0 0 1");
  }
  if (has_size(node.translation, 3, "translation"))
    transform.translate(Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
  if (has_size(node.rotation, 4, "rotation")) {
    const Eigen::Quaterniond rotation(Eigen::Map<const Eigen::Vector4d>(node.rotation.data()));  // x y z w
    if (!(rotation.norm() > 1e-6))
      refuse(document, where + ".rotation", "is not a rotation (its length is 0)");
    transform.rotate(rotation.normalized());
  }
  if (has_size(node.scale, 3, "scale")) transform.scale(Eigen::Map<const Eigen::Vector3d>(node.scale.data()));
  if (!transform.matrix().allFinite()) refuse(document, where, "its transform is not finite");
  return transform;
}

bool shows_itself(const tinygltf::Node& node) {
  const auto extension = node.extensions.find("KHR_node_visibility");
  if (extension == node.extensions.end() || !extension->second.Has("visible")) return true;
  const tinygltf::Value& visible = extension->second.Get("visible");
  return !visible.IsBool() || visible.Get<bool>();
}

std::vector<int> root_nodes(const Document& document, int scene) {
  const tinygltf::Model& model = document.model;
  if (scene != -1) return model.scenes[scene].nodes;
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children)
      if (in_range(child, model.nodes)) is_child[child] = true;
  std::vector<int> roots;
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  return roots;
}

}  // namespace

int scene_to_read(const Document& document) {
  const tinygltf::Model& model = document.model;
  if (model.defaultScene == -1) return model.scenes.empty() ? -1 : 0;
  if (!in_range(model.defaultScene, model.scenes))
    refuse(document, "scene", std::to_string(model.defaultScene) + " does not exist");
  return model.defaultScene;
}

std::vector<PlacedNode> place_nodes(const Document& document, int scene) {
  const std::vector<tinygltf::Node>& nodes = document.model.nodes;
  std::vector<PlacedNode> placed, stack;
  std::vector<bool> is_placed(nodes.size(), false);
  const auto push_reversed = [&](const std::vector<int>& children, const Eigen::Affine3d& parent,
                                 bool is_visible) {
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      stack.push_back({*child, parent, is_visible});
  };
  push_reversed(root_nodes(document, scene), Eigen::Affine3d::Identity(), true);
  while (!stack.empty()) {
    auto [index, world_from_parent, is_parent_visible] = stack.back();
    stack.pop_back();
    const std::string where = element("nodes", index);
    if (!in_range(index, nodes)) refuse(document, where, "does not exist");
    if (is_placed[index]) refuse(document, where, "is reached twice: the nodes must form trees");
    is_placed[index] = true;
    placed.push_back({index, world_from_parent * local_transform(document, nodes[index], where),
                      is_parent_visible && shows_itself(nodes[index])});
    push_reversed(nodes[index].children, placed.back().world_from_node, placed.back().is_visible);
  }
  return placed;
}

Eigen::Vector3d far_origin(const Document& document, const std::vector<PlacedNode>& nodes) {
  const tinygltf::Model& model = document.model;
  Eigen::AlignedBox3d middles;
  for (const PlacedNode& place : nodes) {
    const int mesh = model.nodes[place.node].mesh;
    if (!place.is_visible || !in_range(mesh, model.meshes)) continue;
    for (const tinygltf::Primitive& primitive : model.meshes[mesh].primitives) {
      const auto position = primitive.attributes.find("POSITION");
      if (position == primitive.attributes.end() || !in_range(position->second, model.accessors)) continue;
      const tinygltf::Accessor& accessor = model.accessors[position->second];
      if (accessor.minValues.size() != 3 || accessor.maxValues.size() != 3) continue;
      const Eigen::Vector3d low(accessor.minValues.data()), high(accessor.maxValues.data());
      const Eigen::Vector3d middle = place.world_from_node * Eigen::Vector3d(0.5 * (low + high));
      if (middle.allFinite()) middles.extend(middle);
    }
  }
  constexpr double far_m = 10'000;
  if (middles.isEmpty() || middles.center().norm() < far_m) return Eigen::Vector3d::Zero();
  return middles.center().array().round();
}

}  // namespace cps::gltf
