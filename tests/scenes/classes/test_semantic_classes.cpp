#include <catch2/catch.hpp>

#include "scenes/classes/semantic_classes.h"
#include "scenes/ego_bonnet.h"

using namespace cps;

namespace {

/// A scene of one mesh for each material, and an instance for each pair (object, material).
Scene named_scene(const std::vector<std::string>& objects, const std::vector<std::string>& materials,
                  const std::vector<std::pair<int, int>>& instances) {
  Scene scene;
  scene.name = "named";
  scene.objects = objects;
  for (const std::string& name : materials) {
    scene.meshes.emplace_back().material = static_cast<int>(scene.materials.size());
    scene.materials.emplace_back().name = name;
  }
  for (const auto& [object, mesh] : instances) scene.instances.push_back({.mesh = mesh, .object = object});
  return scene;
}

/// A scene of that many objects and materials, each used once, together.
Scene scene_of_pairs(int count) {
  std::vector<std::string> names;
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < count; ++i) {
    names.push_back(std::to_string(i));
    pairs.emplace_back(i, i);
  }
  return named_scene(names, names, pairs);
}

}  // namespace

TEST_CASE("each pair of object name and material name is a class, in order of appearance") {
  // Two objects and two materials share a name; the third object has none.
  const Scene scene = named_scene({"car", "car", ""}, {"paint", "glass", "paint"},
                                  {{1, 1}, {1, 0}, {0, 2}, {0, 1}, {2, 0}, {1, 1}});
  const SceneClasses result = semantic_classes(scene);
  CHECK(result.of_instance == std::vector<std::uint16_t>{1, 2, 2, 1, 3, 1});
  CHECK(result.background == 0);
  REQUIRE(result.classes.size() == 3);
  const std::vector<std::pair<std::string, std::string>> pairs{
      {"car", "glass"}, {"car", "paint"}, {"", "paint"}};
  for (int i = 0; i < 3; ++i) {
    CHECK(result.classes[i].id == i + 1);
    CHECK(result.classes[i].name.empty());
    CHECK(result.classes[i].has_instances);
    CHECK(result.classes[i].object == pairs[i].first);
    CHECK(result.classes[i].material == pairs[i].second);
  }
}

TEST_CASE("a scene made by hand, without objects, has a class for each material's name") {
  const Scene scene = named_scene({}, {"a", "b"}, {{0, 0}, {0, 1}, {0, 0}});
  CHECK(semantic_classes(scene).of_instance == std::vector<std::uint16_t>{1, 2, 1});
}

TEST_CASE("the bonnet is an object and, last, a class of its own in any scene") {
  Scene scene = named_scene({"house"}, {"brick"}, {{0, 0}});
  add_ego_bonnet(scene);
  CHECK(scene.objects == std::vector<std::string>{"house", "ego vehicle"});
  CHECK(scene.instances[1].object == 1);
  const SceneClasses result = semantic_classes(scene);
  CHECK(result.of_instance == std::vector<std::uint16_t>{1, 2});
  CHECK(result.classes.back().object == "ego vehicle");
}

TEST_CASE("scenes with more objects or classes than 16 bits number are refused") {
  const SceneClasses most = semantic_classes(scene_of_pairs(65535));
  CHECK(most.of_instance.back() == 65535);
  CHECK(most.classes.back().id == 65535);
  CHECK(object_ids(scene_of_pairs(65535)).back() == 65535);
  CHECK_THROWS_WITH(object_ids(scene_of_pairs(65536)),
                    "named: more than 65535 objects, the most that labels of 16 bits tell apart: use a "
                    "smaller scene, or leave instance out of the labels");
  // Few objects, each of many materials.
  std::vector<std::string> materials;
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < 32768; ++i) {
    materials.push_back(std::to_string(i));
    for (const int object : {0, 1}) pairs.emplace_back(object, i);
  }
  CHECK_THROWS_WITH(semantic_classes(named_scene({"a", "b"}, materials, pairs)),
                    "named: more than 65535 pairs of object and material, the most that labels of 16 bits "
                    "tell apart: give objects of a kind the same name, or leave semantic out of the labels");
}
