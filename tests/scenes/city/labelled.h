#pragma once

#include <set>
#include <string>

#include "scenes/city/geometry/mesh.h"
#include "scenes/classes/semantic_classes.h"
#include "scenes/gltf_import.h"
#include "scenes/scene_rays.h"

namespace cps {

using Names = std::set<std::string>;

/// A city's file with the classes of what is in it.
struct Labelled {
  Scene scene;
  SceneClasses classes;
  SceneRays rays;

  explicit Labelled(const std::filesystem::path& file)
      : scene(import_gltf(file)), classes(semantic_classes(scene)), rays(scene) {}

  const std::string& object(int instance) const { return scene.objects[scene.instances[instance].object]; }
  const std::string& class_of(int instance) const {
    return classes.classes[classes.of_instance[instance]].name;
  }
  /// The class of what is seen from a point, "" for nothing.
  std::string seen(const Eigen::Vector3f& from, const Eigen::Vector3f& direction) const {
    const auto hit = first_hit(rays, from, direction);
    return hit ? class_of(hit->instance) : "";
  }
  std::string below(const Eigen::Vector3f& from) const { return seen(from, {0, -1, 0}); }
  std::string under_the_sky(const city::Vec2& plan) const {
    return below(city::lift(plan, 1000).cast<float>());
  }
};

}  // namespace cps
