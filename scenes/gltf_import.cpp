#include "scenes/gltf_import.h"

#include <new>

#include "scenes/enclosures.h"
#include "scenes/gltf/cameras.h"
#include "scenes/gltf/document/container.h"
#include "scenes/gltf/document/extensions.h"
#include "scenes/gltf/document/nodes.h"
#include "scenes/gltf/instances.h"
#include "scenes/gltf/lanes.h"
#include "scenes/gltf/lights.h"
#include "scenes/instance_boxes.h"

namespace cps {
namespace {

using namespace gltf;

Eigen::AlignedBox3f bounds_of(const Document& document, const Scene& scene) {
  Eigen::AlignedBox3f bounds;
  for (const Eigen::AlignedBox3f& box : instance_boxes(scene)) bounds.extend(box);
  constexpr float farthest_m = 1e7f;  // a float's resolution is 1 m there
  if (!(bounds.min().minCoeff() > -farthest_m && bounds.max().maxCoeff() < farthest_m))
    refuse(document, "scene", "reaches beyond 10,000 km: scale it to metres");
  return bounds;
}

Scene make_scene(Document& document) {
  Scene scene;
  const int index = scene_to_read(document);
  if (index != -1) scene.name = document.model.scenes[index].name;
  if (scene.name.empty()) scene.name = document.file.stem().string();
  scene.credits = document.model.asset.copyright;
  scene.generator = document.model.asset.generator;
  MeshTable meshes{document, scene, {document, scene}};
  std::vector<PlacedNode> nodes = place_nodes(document, index);
  scene.origin = far_origin(document, nodes);
  for (PlacedNode& node : nodes) node.world_from_node.pretranslate(-scene.origin);
  add_instances(meshes, nodes);
  add_lights(document, nodes, scene);
  if (scene.instances.empty()) refuse(document, "scene", "holds no triangles to draw");
  scene.bounds = bounds_of(document, scene);
  mark_enclosures(scene);
  scene.lanes = read_lanes(document, index, scene.origin);
  scene.cameras = read_cameras(document, nodes);
  warn_of_ignored_extensions(document);
  return scene;
}

}  // namespace

Scene import_gltf(const std::filesystem::path& file, std::size_t max_decoded_bytes) try {
  Document document = read_document(file, max_decoded_bytes);
  Scene scene = make_scene(document);
  scene.import_warnings = std::move(document.warnings);
  return scene;
} catch (const std::bad_alloc&) {
  refuse(file, "memory", "not enough to read this file");
}

}  // namespace cps
