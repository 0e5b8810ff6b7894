#include "scenes/enclosures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scenes/instance_boxes.h"
#include "scenes/lattice.h"

namespace cps {
namespace {

using Eigen::Vector3d;

constexpr int directions = 64, max_open = 3;
constexpr double lowest_sine = 0.17, high_sine = 0.7;  ///< of elevations of 10° and 44°

/// Distance along the ray to the triangle, 0 if it is missed (Möller & Trumbore 1997).
double distance_to(const Vector3d& from, const Vector3d& direction, const Vector3d (&corner)[3]) {
  const Vector3d a = corner[1] - corner[0], b = corner[2] - corner[0], p = direction.cross(b);
  const double determinant = a.dot(p);
  if (determinant == 0) return 0;
  const Vector3d s = from - corner[0], q = s.cross(a);
  const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return 0;
  return std::max(0.0, b.dot(q) / determinant);
}

bool may_hit(const Vector3d& from, const Vector3d& direction, const Eigen::AlignedBox3d& box) {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - from[axis]) / direction[axis],
                 b = (box.max()[axis] - from[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

struct LastHit {
  int mesh = -1;
  double distance = 0;
};

LastHit last_hit(const Scene& scene, const std::vector<Eigen::AlignedBox3d>& boxes, const Vector3d& from,
                 const Vector3d& direction) {
  LastHit last;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!may_hit(from, direction, boxes[i])) continue;
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Eigen::Affine3d world_from_mesh = instance.world_from_mesh.cast<double>();
    for (const Eigen::Vector3i& t : mesh.triangles) {
      Vector3d corner[3];
      for (int c = 0; c < 3; ++c) corner[c] = world_from_mesh * mesh.positions[t[c]].cast<double>();
      const double distance = distance_to(from, direction, corner);
      if (distance > last.distance) last = {instance.mesh, distance};
    }
  }
  return last;
}

/// The meshes that close the sky over a place; none if it is open.
std::set<int> closing_meshes(const Scene& scene, const std::vector<Eigen::AlignedBox3d>& boxes,
                             const Vector3d& from) {
  std::vector<LastHit> high, low;
  int open = 0;
  for (int i = 0; i < directions; ++i) {
    const Vector3d direction = lattice_direction(i, directions, lowest_sine);
    const LastHit hit = last_hit(scene, boxes, from, direction);
    if (hit.mesh < 0 && ++open > max_open) return {};
    if (hit.mesh >= 0) (direction.y() > high_sine ? high : low).push_back(hit);
  }
  if (high.empty()) return {};
  std::ranges::sort(high, {}, &LastHit::distance);
  const double typical = high[high.size() / 2].distance;
  std::set<int> meshes;
  // Houses that are taller than the lower parts of the shell do not belong to it.
  for (const std::vector<LastHit>& hits : {high, low})
    for (const LastHit& hit : hits)
      if (hit.distance >= 0.5 * typical) meshes.insert(hit.mesh);
  return meshes;
}

/// The point of which each coordinate exceeds this share of the boxes' middles.
Vector3d quantile(const std::vector<Eigen::AlignedBox3d>& boxes, double share) {
  Vector3d point;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> middles;
    for (const Eigen::AlignedBox3d& box : boxes) middles.push_back(box.center()[axis]);
    const auto at =
        middles.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(middles.size()));
    std::ranges::nth_element(middles, at);
    point[axis] = *at;
  }
  return point;
}

/// Whether the meshes' box holds the middles of nearly all boxes: a house closes the sky over its rooms only.
bool hold_the_scene(const Scene& scene, const std::vector<Eigen::AlignedBox3d>& boxes,
                    const std::set<int>& meshes) {
  Eigen::AlignedBox3d whole;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (meshes.contains(scene.instances[i].mesh)) whole.extend(boxes[i]);
  // The lower half of a dome may be missing.
  const auto held = std::ranges::count_if(boxes, [&](const Eigen::AlignedBox3d& box) {
    const Vector3d middle = box.center();
    return middle.x() >= whole.min().x() && middle.x() <= whole.max().x() && middle.z() >= whole.min().z() &&
           middle.z() <= whole.max().z() && middle.y() <= whole.max().y();
  });
  return static_cast<double>(held) >= 0.95 * static_cast<double>(boxes.size());
}

}  // namespace

void mark_enclosures(Scene& scene) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Eigen::AlignedBox3f& box : instance_boxes(scene)) boxes.push_back(box.cast<double>());
  const Vector3d middle = quantile(boxes, 0.5);
  std::set<int> meshes;
  for (double share : {0.5, 0.25, 0.75}) {
    Vector3d from = quantile(boxes, share);
    from.y() = middle.y();
    const std::set<int> found = closing_meshes(scene, boxes, from);
    if (found.empty()) return;
    meshes.insert(found.begin(), found.end());
  }
  if (!hold_the_scene(scene, boxes, meshes)) return;
  for (int mesh : meshes) scene.meshes[mesh].is_enclosure = true;
}

Eigen::AlignedBox3f bounds_without_enclosures(const Scene& scene) {
  const auto is_enclosure = [](const Mesh& mesh) { return mesh.is_enclosure; };
  if (std::ranges::none_of(scene.meshes, is_enclosure)) return scene.bounds;
  const std::vector<Eigen::AlignedBox3f> boxes = instance_boxes(scene);
  Eigen::AlignedBox3f bounds;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!scene.meshes[scene.instances[i].mesh].is_enclosure) bounds.extend(boxes[i]);
  return bounds.isEmpty() ? scene.bounds : bounds;
}

}  // namespace cps
