#include "scenes/classes/semantic_classes.h"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "scenes/classes/city_classes.h"

namespace cps {
namespace {

constexpr std::size_t most_ids = 65535;  ///< that 16 bits hold beside 0

[[noreturn]] void refuse(const Scene& scene, const std::string& what, const std::string& fix) {
  throw std::runtime_error(fmt::format("{}: more than {} {}, the most that labels of 16 bits tell apart: {}",
                                       scene.name, most_ids, what, fix));
}

std::string_view object_name(const Scene& scene, const Instance& instance) {
  return scene.objects.empty() ? std::string_view() : scene.objects[instance.object];
}

/// A class for each pair of object name and material name.
SceneClasses classes_by_name(const Scene& scene) {
  SceneClasses result;
  std::map<std::pair<std::string_view, std::string_view>, std::uint16_t> ids;
  for (const Instance& instance : scene.instances) {
    const std::string_view object = object_name(scene, instance),
                           material = scene.materials[scene.meshes[instance.mesh].material].name;
    const auto [found, is_new] = ids.try_emplace({object, material});
    if (is_new) {
      if (ids.size() > most_ids)
        refuse(scene, "pairs of object and material",
               "give objects of a kind the same name, or leave semantic out of the labels");
      found->second = static_cast<std::uint16_t>(ids.size());
      result.classes.push_back({.id = found->second,
                                .has_instances = true,
                                .object = std::string(object),
                                .material = std::string(material)});
    }
    result.of_instance.push_back(found->second);
  }
  return result;
}

}  // namespace

SceneClasses semantic_classes(const Scene& scene) {
  return is_procedural_city(scene) ? city_classes(scene) : classes_by_name(scene);
}

std::vector<std::uint16_t> object_ids(const Scene& scene) {
  if (scene.objects.size() > most_ids)
    refuse(scene, "objects", "use a smaller scene, or leave instance out of the labels");
  std::vector<std::uint16_t> ids;
  for (const Instance& instance : scene.instances)
    ids.push_back(static_cast<std::uint16_t>(1 + instance.object));
  return ids;
}

}  // namespace cps
