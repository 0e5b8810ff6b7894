#include "production/drive_text.h"

#include <boost/program_options.hpp>
#include <sstream>

#include "files/files.h"
#include "sampler/recipe/recipe_values.h"

namespace po = boost::program_options;

namespace cps {

std::string fault_of(const DriveOptions& drive, const Recipe& recipe) {
  const double scale = drive.metres_per_unit;
  if (!(scale == 0 || (scale >= 1e-6 && scale <= 1e6)))
    return "metres_per_unit: must be 0 or lie in [1e-6, 1e6]";
  const bool is_one_scene = recipe.scenes.size() == 1 && recipe.city_seeds.empty() && recipe.cities == 0;
  if (!drive.route.empty() && !is_one_scene) return "route: needs a recipe with one scene and no city";
  return {};
}

std::string to_text(const DriveOptions& drive) {
  std::string text =
      "metres_per_unit = " + value_text(drive.metres_per_unit) + "\nroute = " + drive.route.string() + "\n";
  if (drive.is_z_up) text += "up = z\n";
  if (!drive.route.empty()) text += "route_sha256 = " + sha256(read_file(drive.route)) + "\n";
  return text;
}

DriveOptions drive_from_text(const std::string& text) {
  po::options_description keys;
  keys.add_options()("metres_per_unit", po::value<double>()->default_value(0))(
      "route", po::value<std::string>()->default_value(""))("route_sha256", po::value<std::string>())(
      "up", po::value<std::string>()->default_value("y"));
  std::istringstream lines(text);
  po::variables_map values;
  po::store(po::parse_config_file(lines, keys), values);
  return {.metres_per_unit = values["metres_per_unit"].as<double>(),
          .is_z_up = values["up"].as<std::string>() == "z",
          .route = values["route"].as<std::string>()};
}

}  // namespace cps
