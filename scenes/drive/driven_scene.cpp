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

/// Mean share of directions in which things stand beside the drives.
double things_along(const std::vector<Lane>& drives, const GroundGrid& ground) {
  double sum = 0, points = 0;
  for (const Lane& drive : drives)
    for (const Eigen::Vector3f& point : drive.points) {
      sum += ground.around_at({point.x(), point.z()}).share();
      ++points;
    }
  return sum / points;
}

struct FoundDrives {
  std::vector<Lane> lanes;
  std::string why;  ///< what speaks for their ground
};

FoundDrives found_drives(const Scene& scene, const std::filesystem::path& file) {
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
  const double things = things_along(drives, ground);
  return {std::move(drives),
          fmt::format("on ground at y = {:.1f} m with things in {:.0f} % of all directions{}", ground.level_m,
                      100 * things,
                      ground.rivals > 0 ? fmt::format(", the best of {} grounds", ground.rivals + 1) : "")};
}

std::string scale_text(double metres_per_unit, const DriveOptions& options) {
  const bool is_guessed = options.metres_per_unit == 0 && metres_per_unit != 1;
  return fmt::format("{:g} m per unit{}", metres_per_unit, is_guessed ? " (guessed from its size)" : "");
}

double length_m(const std::vector<Lane>& lanes) {
  double sum_m = 0;
  for (const Lane& lane : lanes) sum_m += length_m(lane);
  return sum_m;
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
  std::string lanes_are = "lanes", why;
  if (!options.route.empty()) {
    scene.lanes = read_route(options.route, {scale, options.is_z_up, scene.origin});
  } else if (!has_lanes) {
    FoundDrives found = found_drives(scene, file);
    scene.lanes = std::move(found.lanes);
    lanes_are = "drives found";
    why = " " + found.why;
  }
  if (!has_lanes || !options.route.empty() || scale != 1)
    driven.note =
        fmt::format("{}: {}, {} {}, {:.0f} m{}", file.filename().string(), scale_text(scale, options),
                    scene.lanes.size(), lanes_are, length_m(scene.lanes), why);
  return driven;
}

}  // namespace cps
