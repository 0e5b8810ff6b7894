#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sampler/recipe/recipe.h"

/// The recipe in dataset.json: a text for each key, as in a recipe file.
namespace cps {

nlohmann::ordered_json recipe_json(const Recipe& recipe);

/// The recipe of a finished dataset. Keys that an older version did not write have their defaults. Throws
/// std::runtime_error with one line: file, key, what is wrong.
Recipe read_recipe(const std::filesystem::path& dataset);

}  // namespace cps
