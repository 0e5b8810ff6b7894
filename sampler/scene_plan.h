#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sampler/recipe.h"
#include "scenes/city/city.h"

namespace cps {

struct PlannedScene {
  std::filesystem::path file;
  std::optional<CityOptions> city = std::nullopt;  ///< what the file is made from; none: it was there before
  double metres_per_unit = 1;                      ///< known once the scene is loaded
  std::string credits = {};                        ///< as the file states them, known then too
};

/// The recipe's scenes: its files, then its procedural cities as files in `city_folder`, those of `city_seed`
/// before the drawn ones. Nothing is read or made.
std::vector<PlannedScene> plan_scenes(const Recipe& recipe, const std::filesystem::path& city_folder);

}  // namespace cps
