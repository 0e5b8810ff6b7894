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
  const auto push_reversed = [&](const std::vector<int>& children, const Eigen::Affine3d& parent) {
    for (auto child = children.rbegin(); child != children.rend(); ++child) stack.push_back({*child, parent});
  };
  push_reversed(root_nodes(document, scene), Eigen::Affine3d::Identity());
  while (!stack.empty()) {
    auto [index, world_from_parent] = stack.back();
    stack.pop_back();
    const std::string where = element("nodes", index);
    if (!in_range(index, nodes)) refuse(document, where, "does not exist");
    if (is_placed[index]) refuse(document, where, "is reached twice: the nodes must form trees");
    is_placed[index] = true;
    placed.push_back({index, world_from_parent * local_transform(document, nodes[index], where)});
    push_reversed(nodes[index].children, placed.back().world_from_node);
  }
  return placed;
}

}  // namespace cps::gltf
