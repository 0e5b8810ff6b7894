#include "scenes/instance_boxes.h"

namespace cps {

std::vector<Eigen::AlignedBox3f> instance_boxes(const Scene& scene) {
  std::vector<Eigen::AlignedBox3f> mesh_boxes(scene.meshes.size()), boxes;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    for (const Eigen::Vector3f& position : scene.meshes[i].positions) mesh_boxes[i].extend(position);
  for (const Instance& instance : scene.instances)
    boxes.push_back(mesh_boxes[instance.mesh].transformed(instance.world_from_mesh));
  return boxes;
}

}  // namespace cps
