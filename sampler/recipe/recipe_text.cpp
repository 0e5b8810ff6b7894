#include <algorithm>
#include <boost/program_options/parsers.hpp>
#include <fstream>
#include <sstream>

#include "sampler/recipe/key_options.h"
#include "sampler/recipe/lens_check.h"
#include "sampler/recipe/recipe.h"
#include "sampler/recipe/recipe_keys.h"
#include "sampler/recipe/recipe_scale.h"

/// Recipes as options and as the text of a file.

namespace po = boost::program_options;

namespace cps {
namespace {

/// The text of a recipe file with `_` for every `-` in its keys.
std::stringstream with_plain_keys(std::istream& file) {
  std::stringstream text;
  for (std::string line; std::getline(file, line);) {
    std::replace(line.begin(), std::find(line.begin(), line.end(), '='), '-', '_');
    text << line << "\n";
  }
  return text;
}

bool is_scene_key(const std::string& key) {
  return key == "scene" || key == "city_seed" || key == "cities";
}

bool names_scenes(const po::variables_map& values) {
  return std::any_of(values.begin(), values.end(),
                     [](const auto& value) { return is_scene_key(value.first); });
}

}  // namespace

po::options_description recipe_options() {
  const Recipe defaults;
  po::options_description options =
      key_options("Recipe keys (in the recipe file, or as options that override it)",
                  [&](auto visit) { for_each_recipe_key(defaults, visit); });
  options.add_options()("scale", po::value<double>()->default_value(1),
                        "makes the dataset smaller or larger: multiplies the numbers of views and scenes, of "
                        "which at least 3 and 1 are left; above 0, at most 100");
  return options;
}

void store_recipe_file(const std::filesystem::path& file, po::variables_map& values) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read; name a recipe file");
  try {
    std::stringstream text = with_plain_keys(stream);
    const po::options_description known = recipe_options();  // outlives `keys`, which points to it
    po::parsed_options keys = po::parse_config_file(text, known);
    if (names_scenes(values))
      std::erase_if(keys.options, [](const po::option& key) { return is_scene_key(key.string_key); });
    po::store(keys, values);
  } catch (const po::error& error) {
    throw std::runtime_error(file.string() + ": " + error.what() + "; `cps help generate` lists the keys");
  }
}

Recipe recipe_from(const po::variables_map& values) {
  Recipe recipe;
  try {
    read_keys(values, [&](auto visit) { for_each_recipe_key(recipe, visit); });
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("recipe: ") + error.what());
  }
  if (!recipe.is_brown_conrady() && values.count("undistorted") == 0) recipe.undistorted = false;
  std::ranges::sort(recipe.labels);
  if (const std::string fault = recipe.fault(); !fault.empty()) throw std::runtime_error("recipe: " + fault);
  require_lenses(recipe);
  if (values.count("scale") > 0) recipe = scaled_recipe(recipe, values["scale"].as<double>());
  return recipe;
}

std::string to_text(const Recipe& recipe) {
  std::string text;
  for_each_written_key(recipe, [&](const char* key, const auto& value, const char*) {
    text += std::string(key) + " = " + value_text(value) + "\n";
  });
  return text;
}

}  // namespace cps
