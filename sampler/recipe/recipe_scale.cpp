#include "sampler/recipe/recipe_scale.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cps {
namespace {

template <typename T>
void keep_share(std::vector<T>& list, double scale) {
  const auto kept = static_cast<std::size_t>(std::ceil(static_cast<double>(list.size()) * scale));
  list.resize(std::min(list.size(), kept));
}

}  // namespace

Recipe scaled_recipe(Recipe recipe, double scale) {
  if (!(scale > 0 && scale <= 100)) throw std::runtime_error("scale: must be above 0 and at most 100");
  if (scale == 1) return recipe;
  for (int& views : recipe.views.values) views = std::max(3, static_cast<int>(std::lround(views * scale)));
  // Rounded up, so that no kind of scene is lost.
  recipe.cities = static_cast<int>(std::ceil(recipe.cities * scale));
  keep_share(recipe.scenes, scale);
  keep_share(recipe.city_seeds, scale);
  if (const std::string fault = recipe.fault(); !fault.empty())
    throw std::runtime_error("recipe: " + fault + " (after scale)");
  return recipe;
}

}  // namespace cps
