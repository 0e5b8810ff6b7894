#include "sampler/scene_plan.h"

#include <fmt/format.h>

#include "random/counter_hash.h"

namespace cps {

std::vector<PlannedScene> plan_scenes(const Recipe& recipe, const std::filesystem::path& city_folder) {
  std::vector<PlannedScene> scenes;
  for (const std::string& file : recipe.scenes) scenes.push_back({.file = file});

  std::vector<std::uint64_t> seeds = recipe.city_seeds;
  const Stream drawn = make_stream(recipe.seed, "city"), traffic = make_stream(recipe.seed, "traffic");
  constexpr std::uint64_t seed_count = 1'000'000'000;  // short file names
  for (int i = 0; i < recipe.cities; ++i) seeds.push_back(random_below(drawn, i, seed_count));
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const CityOptions city{.seed = seeds[i],
                           .style = recipe.city_styles[i % recipe.city_styles.size()],
                           .traffic = random_uniform(traffic, i, recipe.traffic_min, recipe.traffic_max)};
    scenes.push_back({.file = city_folder / fmt::format("city_{}_{}.glb", to_string(city.style), city.seed),
                      .city = city});
  }
  return scenes;
}

}  // namespace cps
