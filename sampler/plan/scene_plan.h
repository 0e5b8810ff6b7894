#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "random/counter_hash.h"
#include "sampler/recipe/recipe.h"
#include "scenes/city/city.h"

namespace cps {

/// A file with the streets, and, of a city, with the traffic of one day: each of a city's conditions shows
/// another, in the same streets.
struct PlannedScene {
  std::filesystem::path file;
  std::optional<CityOptions> city = std::nullopt;  ///< what the file is made from; none: it was there before
  double metres_per_unit = 1;                      ///< known once the scene is loaded
  std::string credits = {};                        ///< as the file states them, known then too
};

/// The recipe's scenes: its files, then its procedural cities as files in `city_folder`, those of `city_seed`
/// before the drawn ones, each as often as it has conditions. A city that is named twice has twice as many
/// days. Nothing is read or made.
std::vector<PlannedScene> plan_scenes(const Recipe& recipe, const std::filesystem::path& city_folder);

/// Decides which streets of a scene belong to which part: the same for all scenes with the same streets,
/// which are one city's days, or one file named twice.
Stream streets_stream(const Recipe& recipe, const std::vector<PlannedScene>& scenes, std::size_t scene);

}  // namespace cps
