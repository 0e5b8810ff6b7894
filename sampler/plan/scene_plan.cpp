#include "sampler/plan/scene_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace cps {

std::vector<PlannedScene> plan_scenes(const Recipe& recipe, const std::filesystem::path& city_folder) {
  std::vector<PlannedScene> scenes;
  for (const std::string& file : recipe.scenes) scenes.push_back({.file = file});

  std::vector<std::uint64_t> seeds = recipe.city_seeds;
  const Stream drawn = make_stream(recipe.seed, "city");
  constexpr std::uint64_t seed_count = 1'000'000'000;  // keeps file names short
  for (int i = 0; i < recipe.cities; ++i) seeds.push_back(random_below(drawn, i, seed_count));
  std::map<std::pair<CityStyle, std::uint64_t>, std::uint64_t> days;  // number of days of each city so far
  for (std::size_t i = 0; i < seeds.size(); ++i)
    for (int condition = 0; condition < recipe.conditions_per_scene; ++condition) {
      const CityStyle style = recipe.city_styles[i % recipe.city_styles.size()];
      const std::uint64_t day = days[{style, seeds[i]}]++;
      const Stream traffic = substream(make_stream(recipe.seed, "traffic of " + to_string(style)), seeds[i]);
      const CityOptions city{.seed = seeds[i],
                             .traffic_seed = day,
                             .style = style,
                             .traffic = random_uniform(traffic, day, recipe.traffic_min, recipe.traffic_max)};
      scenes.push_back(
          {.file = city_folder / fmt::format("city_{}_{}_day{}.glb", to_string(style), city.seed, day),
           .city = city});
    }
  return scenes;
}

Stream streets_stream(const Recipe& recipe, const std::vector<PlannedScene>& scenes, std::size_t scene) {
  if (const auto& city = scenes[scene].city)
    return substream(make_stream(recipe.seed, "streets of " + to_string(city->style)), city->seed);
  const auto first = std::find_if(scenes.begin(), scenes.end(), [&](const PlannedScene& other) {
    return other.file == scenes[scene].file;
  });
  return substream(make_stream(recipe.seed, "streets"), first - scenes.begin());
}

}  // namespace cps
