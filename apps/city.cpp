#include "scenes/city/city.h"

#include <iostream>

#include "apps/options.h"
#include "apps/verbs.h"

namespace po = boost::program_options;

namespace cps {

int cps_city(const Arguments& arguments) {
  CityOptions city;
  std::string styles = "one of";
  for (const std::string& name : city_style_names()) styles += " " + name;
  po::options_description options("Options");
  options.add_options()("output,o", po::value<std::string>()->required(), "the .glb to write")(
      "seed", po::value(&city.seed)->default_value(city.seed), "the same seed makes the same file")(
      "traffic-seed", po::value(&city.traffic_seed)->default_value(city.traffic_seed),
      "another one: other vehicles and people in the same streets")(
      "style", po::value<std::string>()->default_value(to_string(city.style)), styles.c_str())(
      "extent-m", po::value(&city.extent_m)->default_value(city.extent_m), "side of the area with streets")(
      "tree-density", po::value(&city.tree_density)->default_value(city.tree_density), "0: none … 3")(
      "parked-cars", po::value(&city.parked_cars)->default_value(city.parked_cars), "0: none … 2")(
      "traffic", po::value(&city.traffic)->default_value(city.traffic), "0: none … 2");
  po::variables_map values;
  if (!parse_options(arguments,
                     "cps city --style NAME --seed N -o FILE.glb\nA city to drive through: streets, houses, "
                     "trees, parked cars and "
                     "the lanes between them.\n",
                     options, {}, values))
    return 0;
  po::notify(values);
  city.style = city_style_from(values["style"].as<std::string>());
  if (std::string why; !city.is_valid(&why)) throw po::error(why);
  const std::string output = values["output"].as<std::string>();
  std::cout << write_city(city, output).brief() << '\n' << output << '\n';
  return 0;
}

}  // namespace cps
