#include "production/drive_options.h"

#include "files/files.h"
#include "sampler/recipe/recipe_values.h"

namespace po = boost::program_options;

namespace cps {

po::options_description drive_flags() {
  po::options_description flags("Scenes that know no metres or lanes");
  flags.add_options()("metres_per_unit", po::value<double>()->default_value(0),
                      "metres per unit of the scenes; 0: 1 where they have lanes, else guessed")(
      "route", po::value<std::string>(),
      "a drive through the scene, CSV: x,y,z[,heading_deg] in its units; none: its lanes, else found");
  return flags;
}

DriveOptions drive_options_from(const po::variables_map& values, const Recipe& recipe) {
  DriveOptions drive{.metres_per_unit = values["metres_per_unit"].as<double>(), .route = {}};
  if (!(drive.metres_per_unit == 0 || (drive.metres_per_unit >= 1e-6 && drive.metres_per_unit <= 1e6)))
    throw po::error("--metres_per_unit: must be 0 or lie in [1e-6, 1e6]");
  if (values.count("route") > 0) drive.route = values["route"].as<std::string>();
  if (drive.route.empty()) return drive;
  if (recipe.scenes.size() != 1 || !recipe.city_seeds.empty() || recipe.cities > 0)
    throw po::error("--route: needs a recipe with one scene and no city");
  return drive;
}

std::string to_text(const DriveOptions& drive) {
  std::string text =
      "metres_per_unit = " + value_text(drive.metres_per_unit) + "\nroute = " + drive.route.string() + "\n";
  if (!drive.route.empty()) text += "route_sha256 = " + sha256(read_file(drive.route)) + "\n";
  return text;
}

}  // namespace cps
