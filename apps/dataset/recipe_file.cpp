#include "apps/dataset/recipe_file.h"

#include <filesystem>

#include "apps/share_folder.h"
#include "sampler/recipe/recipe.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

fs::path find_recipe_file(const std::string& named) {
  if (fs::exists(named)) return named;
  const fs::path shipped = share_folder() / "recipes" / (named + ".cfg");
  const bool is_name = named.find('/') == named.npos;
  return is_name && fs::exists(shipped) ? shipped : fs::path(named);
}

}  // namespace

void store_named_recipe(boost::program_options::variables_map& values) {
  if (values.count("recipe") == 0) return;
  auto& file = values.at("recipe").as<std::string>();
  file = find_recipe_file(file).string();
  store_recipe_file(file, values);
}

}  // namespace cps
