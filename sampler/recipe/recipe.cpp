#include "sampler/recipe/recipe.h"

#include <algorithm>
#include <boost/program_options/parsers.hpp>
#include <cmath>
#include <fstream>
#include <map>

#include "sampler/recipe/key_options.h"
#include "sampler/recipe/lens_check.h"
#include "sampler/recipe/recipe_keys.h"
#include "sampler/recipe/recipe_scale.h"

namespace po = boost::program_options;

namespace cps {
namespace {

bool is_between(double value, double low, double high) {
  return value >= low && value <= high;
}

/// The first check that fails gives its reason.
struct Check {
  bool holds;
  const char* reason;
};

/// Whether files of one name in two folders are among them: a dataset tells its scenes apart by name.
bool has_namesakes(const std::vector<std::string>& files) {
  std::map<std::filesystem::path, std::string> by_name;
  return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    return by_name.emplace(std::filesystem::path(file).filename(), file).first->second != file;
  });
}

}  // namespace

bool Recipe::is_valid(std::string* why) const {
  const auto all_sizes = [&](auto holds) {
    for (const ImageSize& size : sizes)
      if (!holds(size)) return false;
    return true;
  };
  bool hfovs_in_range = true;
  for (const auto& hfovs : {base_hfov_deg, hfov_deg})
    for (double hfov : hfovs) hfovs_in_range &= is_between(hfov, 5, 165);
  const auto all_between = [](const PerSize& numbers, int low, int high) {
    return std::all_of(numbers.values.begin(), numbers.values.end(),
                       [&](int number) { return is_between(number, low, high); });
  };
  const auto fits_sizes = [&](const PerSize& numbers) {
    return numbers.values.size() == 1 || numbers.values.size() == sizes.size();
  };
  const Check checks[] = {
      {!name.empty(), "name: must not be empty"},
      {!scenes.empty() || !city_seeds.empty() || cities > 0,
       "scene, city_seed, cities: name at least one scene or city"},
      {!has_namesakes(scenes), "scene: two files in different folders have the same name; rename one"},
      {is_between(cities, 0, 100'000), "cities: must lie in [0, 100000]"},
      {!city_styles.empty(), "city_style: name at least one, as european"},
      {is_between(traffic_min, 0, 2) && is_between(traffic_max, traffic_min, 2),
       "traffic_min ≤ traffic_max: must lie in [0, 2]"},
      {is_between(conditions_per_scene, 1, 100'000), "conditions_per_scene: must lie in [1, 100000]"},
      {!sizes.empty(), "size: name at least one, as 1392x512"},
      {all_sizes([](const ImageSize& s) { return s.width >= 32 && s.height >= 32; }),
       "size: width and height must be at least 32 pixels"},
      {all_sizes([](const ImageSize& s) { return s.width <= 8192 && s.height <= 8192; }),
       "size: width and height must be at most 8192 pixels"},
      {!base_hfov_deg.empty() || !hfov_deg.empty(), "base_hfov_deg, hfov_deg: name at least one"},
      {base_hfov_deg.empty() || hfov_deg.empty(),
       "base_hfov_deg, hfov_deg: one follows from the other; name only one of them"},
      {hfovs_in_range, "base_hfov_deg, hfov_deg: must lie in [5, 165]"},
      {fits_sizes(views), "views: name one number, or as many as there are sizes"},
      {all_between(views, 3, 1'000'000),
       "views: must lie in [3, 1000000], one for each of train, val and test"},
      {is_between(mount_error_deg, 0, 30), "mount_error_deg: must lie in [0, 30]"},
      {is_between(mount_error_m, 0, 0.5), "mount_error_m: must lie in [0, 0.5]"},
      {is_between(lateral_m, 0, 2), "lateral_m: must lie in [0, 2]"},
      {is_between(heading_deg, 0, 45), "heading_deg: must lie in [0, 45]"},
      {is_between(lane_change_share, 0, 1), "lane_change_share: must lie in [0, 1]"},
      {is_between(clearance_m, 0, 50), "clearance_m: must lie in [0, 50]"},
      {is_between(side_clearance_m, 0, 50), "side_clearance_m: must lie in [0, 50]"},
      {fits_sizes(lenses), "lenses: name one number, or as many as there are sizes"},
      {all_between(lenses, 0, 10'000), "lenses: must lie in [0, 10000]"},
      {undistorted || all_between(lenses, 1, 10'000),
       "lenses: must lie in [1, 10000] where undistorted = false"},
      {views_per_lens >= 0, "views_per_lens: must not be negative"},
      {is_between(train_share, 0.01, 0.98) && is_between(val_share, 0.01, 0.98) &&
           train_share + val_share <= 0.99,
       "train_share, val_share: each at least 0.01 and 0.01 left for test"},
      {split == "route" || split == "thesis", "split: must be route or thesis"},
      {is_between(samples, 2, 65536) && samples % 2 == 0,
       "samples: must be even, in [2, 65536]: a master is rendered in two halves"},
      {is_between(max_shaded_vertices, 1, 64), "max_shaded_vertices: must lie in [1, 64]"},
      {is_between(jpeg_quality, 1, 100), "jpeg_quality: must lie in [1, 100]"},
  };
  for (const Check& check : checks)
    if (!check.holds) {
      *why = check.reason;
      return false;
    }
  if (!light.is_valid(why) || !lens_options.is_valid(why)) return false;
  if (const std::string fault = sensor.fault(); !fault.empty()) {
    *why = fault;
    return false;
  }
  if (crop_order() == CropOrder::label_first && lens_options.coefficients.has_k1_range()) {
    *why = "k1_min, k1_max: need base_hfov_deg, as k1 is only known with the base";
    return false;
  }
  return true;
}

po::options_description recipe_options() {
  const Recipe defaults;
  po::options_description options = key_options("Recipe keys (in the file, or as flags that override it)",
                                                [&](auto visit) { for_each_recipe_key(defaults, visit); });
  options.add_options()("scale", po::value<double>()->default_value(1),
                        "makes so much of the recipe: views and cities times this, at least 3 and 1");
  return options;
}

void store_recipe_file(const std::filesystem::path& file, po::variables_map& values) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read; name a recipe file");
  try {
    po::store(po::parse_config_file(stream, recipe_options()), values);
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
  if (std::string why; !recipe.is_valid(&why)) throw std::runtime_error("recipe: " + why);
  require_lenses(recipe);
  if (values.count("scale") > 0) recipe = scaled_recipe(recipe, values["scale"].as<double>());
  return recipe;
}

std::string to_text(const Recipe& recipe) {
  std::string text;
  for_each_recipe_key(recipe, [&](const char* key, const auto& value, const char*) {
    text += std::string(key) + " = " + value_text(value) + "\n";
  });
  return text;
}

}  // namespace cps
