#include "scenes/gltf/cameras.h"

#include <numbers>

namespace cps::gltf {
namespace {

/// The camera's pose. glTF cameras look along −z with y up; ours look along +z with y down.
Eigen::Isometry3d camera_in_world(const Document& document, const PlacedNode& node,
                                  const std::string& where) {
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  world_from_camera.translation() = node.world_from_node.translation();
  const Eigen::Matrix3d linear = node.world_from_node.linear();
  const Eigen::Vector3d forward = -linear.col(2).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d(linear.col(1))).normalized();
  world_from_camera.linear() << right, forward.cross(right), forward;
  if (!world_from_camera.matrix().allFinite() ||
      std::abs(world_from_camera.linear().determinant() - 1) > 1e-6)
    refuse(document, where, "its transform scales the camera's axes to 0");
  return world_from_camera;
}

}  // namespace

std::vector<SceneCamera> read_cameras(Document& document, const std::vector<PlacedNode>& nodes) {
  std::vector<SceneCamera> cameras;
  for (const PlacedNode& placed : nodes) {
    const tinygltf::Node& node = document.model.nodes[placed.node];
    if (node.camera == -1) continue;
    const std::string where = element("nodes", placed.node);
    if (!in_range(node.camera, document.model.cameras))
      refuse(document, where + ".camera", std::to_string(node.camera) + " does not exist");
    const tinygltf::Camera& camera = document.model.cameras[node.camera];
    if (camera.type != "perspective") {
      warn(document, "orthographic cameras are not read");
      continue;
    }
    const double vfov_rad = camera.perspective.yfov;
    if (!(vfov_rad > 0 && vfov_rad < std::numbers::pi))
      refuse(document, element("cameras", node.camera) + ".perspective.yfov",
             "must lie between 0 and pi radians");
    cameras.push_back({.name = camera.name.empty() ? node.name : camera.name,
                       .world_from_camera = camera_in_world(document, placed, where),
                       .vfov_rad = vfov_rad});
  }
  return cameras;
}

}  // namespace cps::gltf
