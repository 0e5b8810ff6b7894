#include "dataset/export/coco_categories.h"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "scenes/classes/cityscapes.h"

namespace cps {
namespace {

using Json = nlohmann::ordered_json;

/// The group that Cityscapes puts a class into: its ids follow the groups.
const char* cityscapes_group(int id) {
  constexpr std::array groups = {
      std::pair{cityscapes::ground, "void"},         std::pair{cityscapes::rail_track, "flat"},
      std::pair{cityscapes::tunnel, "construction"}, std::pair{cityscapes::traffic_sign, "object"},
      std::pair{cityscapes::terrain, "nature"},      std::pair{cityscapes::sky, "sky"},
      std::pair{cityscapes::rider, "human"},         std::pair{cityscapes::bicycle, "vehicle"}};
  for (const auto& [last, name] : groups)
    if (id <= last) return name;
  return "void";
}

using Names = std::pair<std::string, std::string>;  ///< object and material

Names names_of(const Json& listed) {
  return {listed.at("object").get<std::string>(), listed.at("material").get<std::string>()};
}

/// Names of the classes that have one, by id.
std::map<int, std::string> named_classes(const Json& classes) {
  std::map<int, std::string> names;
  for (const Json& scene : classes.at("scenes"))
    for (const Json& listed : scene) {
      if (!listed.contains("name") || !listed.at("has_instances").get<bool>()) continue;
      const int id = listed.at("id");
      const std::string name = listed.at("name");
      if (const auto found = names.try_emplace(id, name).first; found->second != name)
        throw std::runtime_error("dataset.json: the class " + std::to_string(id) + " is " + found->second +
                                 " in one scene and " + name + " in another");
    }
  return names;
}

}  // namespace

CocoCategories coco_categories(const nlohmann::ordered_json& classes) {
  CocoCategories categories{.list = Json::array(), .of_class = {}};
  int last_id = 0;
  for (const auto& [id, name] : named_classes(classes)) {
    categories.list.push_back({{"id", id}, {"name", name}, {"supercategory", cityscapes_group(id)}});
    last_id = id;
  }
  std::map<Names, int> ids;
  std::map<std::string, std::map<int, std::optional<int>>> of_scene;
  for (const auto& [scene, listed_classes] : classes.at("scenes").items()) {
    of_scene[scene][0] = {};  // what has no class, listed or not
    for (const Json& listed : listed_classes) {
      const int class_id = listed.at("id");
      std::optional<int>& id = of_scene[scene][class_id];
      if (!listed.at("has_instances").get<bool>()) continue;
      if (listed.contains("name")) {
        id = class_id;
        continue;
      }
      const Names names = names_of(listed);
      const auto [found, is_new] = ids.try_emplace(names, last_id + 1);
      id = found->second;
      if (!is_new) continue;
      last_id = found->second;
      categories.list.push_back(
          {{"id", last_id}, {"name", names.first + "/" + names.second}, {"supercategory", names.first}});
    }
  }
  for (const Json& scene : classes.at("conditions"))
    categories.of_class.push_back(of_scene[scene.get<std::string>()]);
  return categories;
}

}  // namespace cps
