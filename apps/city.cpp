#include "scenes/city/city.h"

#include <boost/program_options.hpp>
#include <iostream>

namespace cps {

/// `cps city`: makes a city from a seed.
int cps_city(const std::vector<std::string>& arguments) {
  namespace po = boost::program_options;
  CityOptions options;
  std::string output;
  po::options_description description(
      "cps city --seed N -o city.glb: a street scene to drive in, as glTF binary");
  description.add_options()("help,h", "this text")(
      "seed", po::value(&options.seed)->default_value(options.seed), "the same seed makes the same file")(
      "extent", po::value(&options.extent_m)->default_value(options.extent_m),
      "side length of the built area, metres")(
      "tree-density", po::value(&options.tree_density)->default_value(options.tree_density), "0: none … 3")(
      "parked-cars", po::value(&options.parked_cars)->default_value(options.parked_cars), "0: none … 2")(
      "output,o", po::value(&output), "the .glb to write");
  po::variables_map given;
  po::store(po::command_line_parser(arguments).options(description).run(), given);
  po::notify(given);
  if (given.count("help")) {
    std::cout << description;
    return 0;
  }
  if (output.empty()) throw po::required_option("--output");
  if (std::string why; !options.is_valid(&why)) throw po::error("cps city: " + why);
  std::cout << write_city(options, output).brief() << '\n' << output << '\n';
  return 0;
}

}  // namespace cps
