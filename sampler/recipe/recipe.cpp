#include "sampler/recipe/recipe.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sampler/recipe/lens_family.h"

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

/// Whether a recipe file can hold the text: # starts a comment there, and a line ends the value.
bool fits_recipe_file(const std::string& text) {
  return text.find_first_of("#\n\r") == text.npos;
}

/// Whether two files in different folders have the same name: a dataset tells its scenes apart by name.
bool has_namesakes(const std::vector<std::string>& files) {
  std::map<std::filesystem::path, std::string> by_name;
  return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    return by_name.emplace(std::filesystem::path(file).filename(), file).first->second != file;
  });
}

}  // namespace

std::string Recipe::fault() const {
  const auto all_sizes = [&](auto holds) {
    for (const ImageSize& size : sizes)
      if (!holds(size)) return false;
    return true;
  };
  bool hfovs_in_range = true;
  for (const auto& hfovs : {base_hfov_deg, hfov_deg})
    for (double hfov : hfovs) hfovs_in_range &= is_between(hfov, 5, is_brown_conrady() ? 165 : 195);
  const auto all_between = [](const PerSize& numbers, int low, int high) {
    return std::all_of(numbers.values.begin(), numbers.values.end(),
                       [&](int number) { return is_between(number, low, high); });
  };
  const auto fits_sizes = [&](const PerSize& numbers) {
    return numbers.values.size() == 1 || numbers.values.size() == sizes.size();
  };
  const Check checks[] = {
      {!name.empty(), "name: must not be empty"},
      {fits_recipe_file(name), "name: must not contain # or a line break"},
      {std::all_of(scenes.begin(), scenes.end(), fits_recipe_file),
       "scene: a file name must not contain # or a line break; rename it"},
      {fits_recipe_file(rig), "rig: a file name must not contain # or a line break; rename it"},
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
      {hfovs_in_range, is_brown_conrady()
                           ? "base_hfov_deg, hfov_deg: must lie in [5, 165]"
                           : "hfov_deg: must lie in [5, 195] with a lens_model other than brown_conrady"},
      {fits_sizes(views), "views: name one number, or as many as there are sizes"},
      {all_between(views, 3, 1'000'000),
       "views: must lie in [3, 1000000], one for each of train, val and test"},
      {is_between(mount_error_deg, 0, 30), "mount_error_deg: must lie in [0, 30]"},
      {is_between(mount_error_m, 0, 0.5), "mount_error_m: must lie in [0, 0.5]"},
      {is_between(camera_pitch_min_deg, -45, 45) &&
           is_between(camera_pitch_max_deg, camera_pitch_min_deg, 45),
       "camera_pitch_min_deg ≤ camera_pitch_max_deg: must lie in [-45, 45]"},
      {is_between(camera_roll_min_deg, -45, 45) && is_between(camera_roll_max_deg, camera_roll_min_deg, 45),
       "camera_roll_min_deg ≤ camera_roll_max_deg: must lie in [-45, 45]"},
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
      {std::ranges::adjacent_find(labels, std::greater_equal{}) == labels.end(),
       "labels: name each once, in the order in which cps help generate lists them"},
  };
  for (const Check& check : checks)
    if (!check.holds) return check.reason;
  for (const std::string& fault :
       {lens_family_fault(*this), light.fault(), lens_options.fault(), sensor.fault()})
    if (!fault.empty()) return fault;
  if (crop_order() == CropOrder::label_first && lens_options.coefficients.has_k1_range())
    return "k1_min, k1_max: need base_hfov_deg, as k1 is only known with the base";
  return "";
}

}  // namespace cps
