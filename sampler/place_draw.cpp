#include "sampler/place_draw.h"

#include <stdexcept>

#include "distortion/pinhole.h"
#include "sampler/splits.h"

namespace cps {
namespace {

constexpr int max_attempts = 200;
/// A place keeps this far from a lane's ends, where the next street begins.
constexpr double end_margin_m = 3;

/// What one attempt draws, by index into the attempt's stream.
enum Drawn : std::uint64_t { along, lateral, heading, yaw, pitch, roll };

double usable_length_m(const Lane& lane) {
  return std::max(0.0, length_m(lane) - 2 * end_margin_m);
}

}  // namespace

DrivableScene drivable_scene(const Scene& scene, const std::string& name, const Recipe& recipe,
                             Stream stream) {
  DrivableScene drivable{
      .lanes = scene.lanes, .routes = routes(scene), .route_parts = {}, .clearance = ClearanceQuery(scene)};
  if (drivable.lanes.empty())
    throw std::runtime_error(name + ": has no lanes to drive on; give its glTF scene extras.cps_lanes");
  if (recipe.split == "thesis") {
    drivable.route_parts.assign(drivable.routes.size(), Part::all);
    return drivable;
  }
  if (drivable.routes.size() < 3)
    throw std::runtime_error(
        name + ": has " + std::to_string(drivable.routes.size()) +
        " streets, too few for train, val and test; use split = thesis or a larger scene");
  std::vector<double> lengths;
  for (const Route& route : drivable.routes) lengths.push_back(route.length_m);
  drivable.route_parts = deal_parts(lengths, recipe.train_share, recipe.val_share, stream);
  return drivable;
}

DrawnPlace draw_place(const DrivableScene& scene, const RigCamera& camera, Part part, const Recipe& recipe,
                      Stream stream) {
  std::vector<int> lanes;
  double total_length_m = 0;
  for (std::size_t r = 0; r < scene.routes.size(); ++r) {
    if (scene.route_parts[r] != part && scene.route_parts[r] != Part::all) continue;
    for (int lane : scene.routes[r].lanes) {
      lanes.push_back(lane);
      total_length_m += usable_length_m(scene.lanes[lane]);
    }
  }
  for (int attempt = 0; attempt < max_attempts && total_length_m > 0; ++attempt) {
    const Stream draw = substream(stream, attempt);
    double distance_m = random_uniform(draw, along, 0, total_length_m);
    std::size_t chosen = 0;
    while (chosen + 1 < lanes.size() && distance_m > usable_length_m(scene.lanes[lanes[chosen]]))
      distance_m -= usable_length_m(scene.lanes[lanes[chosen++]]);
    const Lane& lane = scene.lanes[lanes[chosen]];
    DrawnPlace drawn{.street = lane.street, .place = {}, .camera = camera, .attempts = attempt + 1};
    drawn.place =
        place_on_lane(lane, distance_m + end_margin_m, recipe.lateral_m * random_normal(draw, lateral),
                      radians(recipe.heading_deg) * random_normal(draw, heading));
    drawn.camera.yaw_deg += recipe.mount_error_deg * random_normal(draw, yaw);
    drawn.camera.pitch_deg += recipe.mount_error_deg * random_normal(draw, pitch);
    drawn.camera.roll_deg += recipe.mount_error_deg * random_normal(draw, roll);
    const Eigen::Isometry3d world_from_camera =
        world_from_vehicle(drawn.place) * vehicle_from_camera(drawn.camera);
    const Eigen::Vector3d forward = world_from_camera.linear().col(2);
    if (is_clear(scene.clearance, world_from_camera.translation(), forward, recipe.clearance_m)) return drawn;
  }
  throw std::runtime_error("no clear place for part " + to_string(part) + " in " +
                           std::to_string(max_attempts) +
                           " attempts; lower clearance_m or use a scene with longer lanes");
}

}  // namespace cps
