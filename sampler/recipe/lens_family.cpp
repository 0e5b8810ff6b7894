#include "sampler/recipe/lens_family.h"

#include <fmt/format.h>

#include <algorithm>

#include "sampler/lenses/model_prior.h"
#include "sampler/recipe/lens_keys.h"
#include "sampler/recipe/recipe_values.h"

namespace cps {
namespace {

/// The first key of the options whose value is not the default; empty if all are.
std::string first_changed_key(const LensOptions& options) {
  const LensOptions defaults;
  std::vector<std::string> texts;
  for_each_lens_key(defaults,
                    [&](const char*, const auto& value, const char*) { texts.push_back(value_text(value)); });
  std::string changed;
  std::size_t i = 0;
  for_each_lens_key(options, [&](const char* key, const auto& value, const char*) {
    if (value_text(value) != texts[i++] && changed.empty()) changed = key;
  });
  return changed;
}

}  // namespace

std::string lens_family_fault(const Recipe& recipe) {
  if (recipe.is_brown_conrady()) return "";
  const auto is_known = [&](std::string_view family) { return family == recipe.lens_model; };
  if (std::ranges::none_of(prior_families(), is_known)) {
    std::string known = "brown_conrady";
    for (const std::string_view family : prior_families()) known += ", " + std::string(family);
    return "lens_model: must be one of " + known;
  }
  constexpr int most_samples = 65536 / 4;  // the renderer's limit
  std::string fault;
  if (!recipe.base_hfov_deg.empty())
    fault = "base_hfov_deg: is an H-FOV before a crop, and there is none; name hfov_deg instead";
  else if (recipe.undistorted)
    fault = "undistorted: must be false, as there is no undistorted master";
  else if (recipe.keep_masters)
    fault = "keep_masters: must be false, as there are no masters";
  else if (recipe.samples > most_samples)
    fault =
        fmt::format("samples: must lie in [2, {}], as a pixel has four times as many paths", most_samples);
  else if (const std::string key = first_changed_key(recipe.lens_options); !key.empty())
    fault = key + ": is for brown_conrady lenses; leave it out";
  return fault.empty() ? "" : fault + fmt::format(" (lens_model = {})", recipe.lens_model);
}

}  // namespace cps
