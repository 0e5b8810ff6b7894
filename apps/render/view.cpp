#include "apps/render/view.h"

#include <cmath>
#include <stdexcept>

#include "apps/render/text_options.h"
#include "numbers/angles.h"

namespace po = boost::program_options;

namespace cps {
namespace {

constexpr double eye_height_m = 1.65;

struct View {
  Eigen::Vector3d position, look_at;
};

Eigen::Isometry3d looking_at(const View& view) {
  const Eigen::Vector3d forward = (view.look_at - view.position).normalized();
  Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitY());
  if (!forward.allFinite() || forward.norm() < 0.5)
    throw po::error("--look-at: must differ from the camera's position");
  if (right.norm() < 1e-6) right = Eigen::Vector3d::UnitX();  // straight up or down
  right.normalize();
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  world_from_camera.linear() << right, forward.cross(right), forward;
  world_from_camera.translation() = view.position;
  return world_from_camera;
}

/// From the start of the first lane along it; without lanes, the whole scene from above one corner.
View default_view(const Scene& scene, const Pinhole& pinhole) {
  for (const Lane& lane : scene.lanes) {
    if (lane.points.size() < 2) continue;
    const Eigen::Vector3d up(0, eye_height_m, 0);
    return {lane.points[0].cast<double>() + up, lane.points[1].cast<double>() + up};
  }
  if (scene.bounds.isEmpty()) return {{0, 0, 3}, {0, 0, 0}};
  const Eigen::Vector3d center = scene.bounds.center().cast<double>();
  const double radius = std::max(0.5 * scene.bounds.diagonal().cast<double>().norm(), 1e-3);
  const double narrower = std::min(pinhole.width / pinhole.fx, pinhole.height / pinhole.fy);
  const double distance = radius / std::sin(std::atan(0.5 * narrower));
  return {center + distance * Eigen::Vector3d(0.6, 0.45, 0.75).normalized(), center};
}

/// A glTF camera by name, else by number.
const SceneCamera& find_camera(const Scene& scene, const std::string& wanted) {
  for (const SceneCamera& camera : scene.cameras)
    if (camera.name == wanted) return camera;
  for (std::size_t i = 0; i < scene.cameras.size(); ++i)
    if (std::to_string(i) == wanted) return scene.cameras[i];
  std::string known;
  for (std::size_t i = 0; i < scene.cameras.size(); ++i)
    known += (i > 0 ? ", " : "") + std::to_string(i) + " '" + scene.cameras[i].name + "'";
  throw std::runtime_error("--camera " + wanted + ": the scene has " +
                           (known.empty() ? "no perspective cameras" : known));
}

}  // namespace

Camera ideal_camera(const RenderRequest& request, const Scene& scene) {
  const SceneCamera* gltf = request.camera ? &find_camera(scene, *request.camera) : nullptr;
  const ImageSize size = parse_size(request.size.value_or("1392x512"));
  // No plane shows what a fisheye does; the ideal camera then stands for its pose and size alone.
  constexpr double widest_deg = 170;
  const double hfov_deg = request.hfov_deg.value_or(70);
  double hfov = radians(hfov_deg < 180 ? hfov_deg : widest_deg);
  if (gltf && !request.hfov_deg)
    hfov = 2 * std::atan(std::tan(0.5 * gltf->vfov_rad) * size.width / size.height);
  Camera camera;
  camera.pinhole = pinhole_from_hfov(size.width, size.height, hfov);
  if (gltf) camera.world_from_camera = gltf->world_from_camera;
  if (gltf && !request.position && !request.look_at) return camera;

  View view = default_view(scene, camera.pinhole);
  if (gltf) {
    view.position = gltf->world_from_camera.translation();
    view.look_at = view.position + gltf->world_from_camera.linear().col(2);
  }
  const Eigen::Vector3d ahead = view.look_at - view.position;
  if (request.position) {
    view.position = parse_point("position", *request.position) - scene.origin;
    view.look_at = view.position + ahead;
  }
  if (request.look_at) view.look_at = parse_point("look-at", *request.look_at) - scene.origin;
  camera.world_from_camera = looking_at(view);
  return camera;
}

}  // namespace cps
