#include "dataset/job/recipe_json.h"

#include <stdexcept>

#include "files/files.h"
#include "files/json_keys.h"
#include "sampler/recipe/recipe_keys.h"
#include "sampler/recipe/recipe_values.h"

namespace cps {

nlohmann::ordered_json recipe_json(const Recipe& recipe) {
  nlohmann::ordered_json json;
  for_each_written_key(
      recipe, [&](const char* key, const auto& value, const char*) { json[key] = value_text(value); });
  return json;
}

Recipe read_recipe(const std::filesystem::path& dataset) {
  const std::string file = (dataset / "dataset.json").string();
  const nlohmann::json json = read_json(file);
  const JsonKeys keys = JsonKeys{json, file}.object("recipe");
  Recipe recipe;
  for_each_recipe_key(recipe, [&](const char* key, auto& member, const char*) {
    if (!keys.json.contains(key)) return;
    try {
      parse_value(keys.text(key), member);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(file + ": recipe: " + key + ": " + error.what());
    }
  });
  if (const std::string fault = recipe.fault(); !fault.empty())
    throw std::runtime_error(file + ": recipe: " + fault);
  return recipe;
}

}  // namespace cps
