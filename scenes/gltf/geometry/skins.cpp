#include "scenes/gltf/geometry/skins.h"

#include <algorithm>
#include <numeric>

#include "scenes/gltf/document/accessors.h"

namespace cps::gltf {

std::vector<Eigen::Affine3f> joint_transforms(Document& document, int skin_index,
                                              std::span<const PlacedNode> placed) {
  const std::string where = element("skins", skin_index);
  if (!in_range(skin_index, document.model.skins)) refuse(document, where, "does not exist");
  const tinygltf::Skin& skin = document.model.skins[skin_index];
  std::vector<Eigen::Affine3d> inverse_binds(skin.joints.size(), Eigen::Affine3d::Identity());
  if (skin.inverseBindMatrices != -1) {
    const Elements matrices = elements(document, skin.inverseBindMatrices, where + ".inverseBindMatrices");
    if (matrices.components != 16 || matrices.component_type != TINYGLTF_COMPONENT_TYPE_FLOAT ||
        matrices.count < skin.joints.size())
      refuse(document, where + ".inverseBindMatrices", "must be one MAT4 of floats for each joint");
    for (std::size_t i = 0; i < inverse_binds.size(); ++i)
      for (int c = 0; c < 16; ++c)
        if (c % 4 != 3) inverse_binds[i](c % 4, c / 4) = component(matrices, i, c);
  }
  std::vector<Eigen::Affine3f> transforms;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const auto joint = std::find_if(placed.begin(), placed.end(),
                                    [&](const PlacedNode& node) { return node.node == skin.joints[i]; });
    if (joint == placed.end()) refuse(document, where + ".joints", "must be nodes of the scene");
    transforms.push_back((joint->world_from_node * inverse_binds[i]).cast<float>());
    if (!transforms.back().matrix().allFinite()) refuse(document, where, "its transforms are not finite");
  }
  return transforms;
}

void blend_to_joints(Mesh& mesh, std::span<const Eigen::Vector4f> joints,
                     std::span<const Eigen::Vector4f> weights, std::span<const Eigen::Affine3f> transforms) {
  std::vector<bool> is_mirrored(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    Eigen::Matrix<float, 3, 4> blended = Eigen::Matrix<float, 3, 4>::Zero();
    for (int c = 0; c < 4; ++c)
      if (weights[i][c] != 0) blended += weights[i][c] * transforms[static_cast<int>(joints[i][c])].affine();
    blended /= weights[i].sum();
    const Eigen::Matrix3f linear = blended.leftCols<3>();
    is_mirrored[i] = linear.determinant() < 0;
    mesh.positions[i] = blended * mesh.positions[i].homogeneous();
    if (!mesh.normals.empty()) mesh.normals[i] = linear.inverse().transpose() * mesh.normals[i];
    if (!mesh.tangents.empty()) {
      mesh.tangents[i].head<3>() = (linear * mesh.tangents[i].head<3>()).normalized();
      if (is_mirrored[i]) mesh.tangents[i].w() *= -1;
    }
  }
  for (Eigen::Vector3i& triangle : mesh.triangles)
    if (is_mirrored[triangle[0]]) std::swap(triangle[1], triangle[2]);
}

}  // namespace cps::gltf
