#include "scenes/city/city.h"

#include <fmt/format.h>

#include <iostream>

#include "apps/options.h"
#include "apps/verbs.h"

namespace po = boost::program_options;

namespace cps {
namespace {

po::options_description describe(CityOptions& city, std::string& style, std::filesystem::path& output) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("out,o", path_value(output)->required(), "the .glb file to write");
  add("seed", po::value(&city.seed)->default_value(city.seed),
      "seed of streets, houses and trees, a whole number from 0");
  add("traffic-seed", po::value(&city.traffic_seed)->default_value(city.traffic_seed),
      "seed of traffic, parked cars and people: another one shows the same streets on another day");
  add("style", po::value(&style)->value_name("NAME")->default_value(style),
      fmt::format("what is built: {}", fmt::join(city_style_names(), ", ")).c_str());
  add("extent-m", po::value(&city.extent_m)->default_value(city.extent_m),
      "side length of the area with streets, metres, 300 to 1200");
  add("tree-density", po::value(&city.tree_density)->default_value(city.tree_density),
      "trees, as a multiple of the seed's own density: 0 (none) to 3");
  add("parked-cars", po::value(&city.parked_cars)->default_value(city.parked_cars),
      "parked cars, as a multiple of the seed's own density: 0 (none) to 2");
  add("traffic", po::value(&city.traffic)->default_value(city.traffic),
      "traffic on the lanes, as a multiple of the style's share: 0 (none) to 2");
  return options;
}

}  // namespace

const Manual city_manual{
    .name = "cps city",
    .summary = "make a procedural city, a .glb, from a seed",
    .synopsis = {"[--seed N] [--style NAME] [--KEY VALUE ...] -o FILE.glb"},
    .description = R"(
Writes a glTF scene of streets, houses, trees, parked cars, traffic and people,
with the lanes that a car may drive on. The same options make the same file.
)",
    .examples = {{"cps city --seed 7 -o city.glb", "makes the city of seed 7"},
                 {"cps city --seed 7 --traffic-seed 2 -o later.glb",
                  "makes the same streets on another day, with other vehicles and people"}},
    .see_also = {"cps render", "cps generate"},
};

int cps_city(const Arguments& arguments) {
  CityOptions city;
  std::string style = to_string(city.style);
  std::filesystem::path output;
  po::variables_map values;
  if (!parse_options(arguments, city_manual, describe(city, style, output), {}, values)) return 0;
  po::notify(values);
  city.style = flag_value<CityStyle>("style", style);
  refuse_flags_with(city.fault());
  std::cout << write_city(city, output).brief() << '\n' << output.string() << '\n';
  return 0;
}

}  // namespace cps
