#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "random/counter_hash.h"
#include "sampler/recipe/recipe.h"
#include "scenes/city/city.h"
#include "scenes/classes/semantic_classes.h"

namespace cps {

/// A scene file. A procedural city has one per condition: the same streets with the traffic of another day.
struct PlannedScene {
  std::filesystem::path file;
  std::optional<CityOptions> city =
      std::nullopt;                               ///< options to make the file from; empty: the file is given
  double metres_per_unit = 1;                     ///< set when the scene is loaded
  bool is_z_up = false;                           ///< the file is; set when the scene is loaded
  std::string credits = {};                       ///< as the file states them; set when the scene is loaded
  std::vector<std::string> import_warnings = {};  ///< set when the scene is loaded
  Eigen::Vector3d origin = {0, 0, 0};             ///< Scene::origin, metres; set when the scene is loaded
  /// Of its semantic labels; set when the scene is loaded, if the recipe asks for such labels.
  std::vector<SemanticClass> classes = {};
};

/// Lists the recipe's scenes: its files, then its procedural cities as files in `city_folder`, those of
/// `city_seed` before the drawn ones, each city once per condition. A city that is named twice has twice as
/// many days. Reads and makes no file.
std::vector<PlannedScene> plan_scenes(const Recipe& recipe, const std::filesystem::path& city_folder);

/// The stream that assigns the streets of a scene to train, val and test: the same for all scenes with the
/// same streets, which are the days of one city, or one file named twice.
Stream streets_stream(const Recipe& recipe, const std::vector<PlannedScene>& scenes, std::size_t scene);

}  // namespace cps
