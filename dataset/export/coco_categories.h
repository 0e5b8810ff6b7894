#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace cps {

/// The classes of a dataset's scenes whose objects are told apart, as the categories of one COCO dataset.
struct CocoCategories {
  nlohmann::ordered_json list;  ///< `categories` of the annotation files, sorted by id
  /// By condition, then by class: the category's id; none for a class without instances.
  std::vector<std::map<int, std::optional<int>>> of_class;
};

/// Classes with a name keep their ids, which are those of Cityscapes. An object and a material that share
/// their names are one category in all scenes; these are numbered on behind the others, in the order in which
/// the scenes list them. `classes`: what scene_classes() returns. Throws std::runtime_error with one line
/// when one id has two names.
CocoCategories coco_categories(const nlohmann::ordered_json& classes);

}  // namespace cps
