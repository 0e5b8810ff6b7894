#include "scenes/drive/driven_scene.h"

#include <fmt/format.h>

#include <stdexcept>

#include "scenes/drive/drive_search.h"
#include "scenes/drive/file_frame.h"
#include "scenes/drive/route_file.h"
#include "scenes/gltf_import.h"
#include "scenes/routes.h"

namespace cps {
namespace {

double metres_per_unit(const Scene& scene, const DriveOptions& options) {
  if (options.metres_per_unit > 0) return options.metres_per_unit;
  return scene.lanes.empty() ? guess_unit_scale(scene) : 1;
}

bool can_be_driven_z_up(Scene scene) {
  turn_z_up(scene);
  const SceneRays rays(scene);
  return !find_drives(ground_grid(scene, rays)).empty();
}

std::vector<Lane> found_drives(const Scene& scene, const std::filesystem::path& file) {
  const SceneRays rays(scene);
  const GroundGrid ground = ground_grid(scene, rays);
  std::vector<Lane> drives = find_drives(ground);
  if (drives.empty()) {
    const Eigen::Vector3f size = scene.bounds.sizes();
    throw std::runtime_error(fmt::format(
        "{}: no way to drive was found: {} ({:.0f} x {:.0f} x {:.0f} m); {}set --metres_per_unit or name a "
        "--route",
        file.string(),
        ground.area_m2 > 0 ? fmt::format("the ground, {:.0f} m2, is too narrow", ground.area_m2)
                           : "no flat ground has things beside it",
        size.x(), size.y(), size.z(), can_be_driven_z_up(scene) ? "it looks z-up: try --up z, " : ""));
  }
  return drives;
}

std::string note_of(const std::filesystem::path& file, double metres_per_unit, bool is_guessed,
                    const std::vector<Lane>& lanes, const char* lanes_are) {
  double driven_m = 0;
  for (const Lane& lane : lanes) driven_m += length_m(lane);
  return fmt::format("{}: {:g} m per unit{}, {} {}, {:.0f} m", file.filename().string(), metres_per_unit,
                     is_guessed ? " (guessed)" : "", lanes.size(), lanes_are, driven_m);
}

}  // namespace

DrivenScene load_driven_scene(const std::filesystem::path& file, const DriveOptions& options) {
  DrivenScene driven{.scene = import_gltf(file)};
  Scene& scene = driven.scene;
  const bool has_lanes = !scene.lanes.empty();
  driven.is_z_up = options.is_z_up;
  if (options.is_z_up) turn_z_up(scene);
  const double scale = driven.metres_per_unit = metres_per_unit(scene, options);
  scale_scene(scene, scale);
  const char* lanes_are = "lanes";
  if (!options.route.empty()) {
    scene.lanes = read_route(options.route, {scale, options.is_z_up, scene.origin});
  } else if (!has_lanes) {
    scene.lanes = found_drives(scene, file);
    lanes_are = "drives found";
  }
  if (!has_lanes || !options.route.empty() || scale != 1)
    driven.note = note_of(file, scale, options.metres_per_unit == 0 && !has_lanes, scene.lanes, lanes_are);
  return driven;
}

}  // namespace cps
