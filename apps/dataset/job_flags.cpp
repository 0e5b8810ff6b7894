#include "apps/dataset/job_flags.h"

#include <boost/program_options/errors.hpp>

#include "apps/dataset/recipe_file.h"
#include "apps/options.h"
#include "apps/threads.h"
#include "production/drive_text.h"
#include "production/top_views.h"
#include "sampler/recipe/rig_file.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

DriveOptions drive_from_flags(const po::variables_map& values, const Recipe& recipe) {
  const auto up = values["up"].as<std::string>();
  if (up != "y" && up != "z") throw po::error("--up " + up + ": must be y or z");
  DriveOptions drive{
      .metres_per_unit = values["metres_per_unit"].as<double>(), .is_z_up = up == "z", .route = {}};
  if (values.count("route") > 0) drive.route = values["route"].as<std::string>();
  if (const std::string fault = fault_of(drive, recipe); !fault.empty()) throw po::error("--" + fault);
  return drive;
}

po::options_description drive_flags() {
  po::options_description flags("Scenes without metres or lanes");
  flags.add_options()("metres_per_unit", po::value<double>()->default_value(0),
                      "metres per unit of the scenes; 0: 1 if they have lanes, otherwise estimated");
  flags.add_options()("up", po::value<std::string>()->value_name("AXIS")->default_value("y"),
                      "axis of the scenes that points up: y, as in glTF, or z");
  flags.add_options()("route", po::value<std::string>()->value_name("FILE"),
                      "CSV file of a drive through the scene: x,y,z[,heading_deg] in its units. Without it "
                      "cars follow the scene's lanes, or else a drive that is searched for");
  flags.add_options()("look", po::value<std::string>()->value_name("FOLDER"),
                      "folder for a picture of each scene from above, with the drives drawn in");
  return flags;
}

}  // namespace

bool parse_job_options(const std::vector<std::string>& arguments, const Manual& manual,
                       po::options_description options, po::variables_map& values) {
  options.add_options()("recipe", po::value<std::string>()->value_name("FILE"),
                        "recipe file, or the name of an installed recipe, such as cps-v3");
  add_threads_option(options);
  options.add(drive_flags()).add(recipe_options());
  if (!parse_options(arguments, manual, options, {}, values)) return false;
  store_named_recipe(values);
  po::notify(values);
  return true;
}

DatasetJob job_from_flags(const po::variables_map& values, const fs::path& root) {
  const Recipe recipe = recipe_from(values);
  const fs::path recipe_folder =
      values.count("recipe") > 0 ? fs::path(values["recipe"].as<std::string>()).parent_path() : fs::path();
  return new_job(recipe, find_rig(recipe.rig, recipe_folder), drive_from_flags(values, recipe), root);
}

void look_with_flags(const po::variables_map& values, Watch& watch) {
  if (values.count("look") > 0) watch.scene_loaded = top_views_in(values["look"].as<std::string>());
}

}  // namespace cps
