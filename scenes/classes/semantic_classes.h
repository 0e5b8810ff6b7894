#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace cps {

/// One class of a scene's semantic labels.
struct SemanticClass {
  int id = 0;                  ///< value of the pixels
  std::string name = {};       ///< Cityscapes' name; "" for scenes other than our cities
  bool has_instances = false;  ///< countable things, as Cityscapes counts them (hasInstances)
  std::string object = {};     ///< for other scenes: the name of the objects of this class
  std::string material = {};   ///< for other scenes: the name of their material
};

struct SceneClasses {
  std::vector<SemanticClass> classes;      ///< ascending by id
  std::vector<std::uint16_t> of_instance;  ///< class id, parallel to Scene::instances
  std::uint16_t background = 0;            ///< where nothing was hit
};

/// The classes of a scene's instances. In cities that `cps city` wrote they are Cityscapes'
/// (city_classes.h). In every other scene each pair of names, object and material, is a class of its own,
/// countable, with ids from 1 in the order of Scene::instances, and 0 is the background. Throws
/// std::runtime_error with one line (scene, what, fix) when there are more than 65,535 pairs, which labels of
/// 16 bits cannot number.
SceneClasses semantic_classes(const Scene& scene);

/// 1 + the object of each of Scene::instances. Throws likewise for more than 65,535 objects.
std::vector<std::uint16_t> object_ids(const Scene& scene);

}  // namespace cps
