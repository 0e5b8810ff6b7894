#include "sampler/place_draw.h"

#include <algorithm>
#include <stdexcept>

#include "distortion/pinhole.h"
#include "sampler/splits.h"

namespace cps {
namespace {

constexpr int max_attempts = 200;
/// A place keeps this far from where a lane begins or ends without a link to another.
constexpr double blind_end_m = 3;
/// And as far from where it goes over into another part's, if the lane is twice as long.
constexpr double other_part_m = 10;

/// What one attempt draws, by index into the attempt's stream.
enum Drawn : std::uint64_t { along, lateral, heading, yaw, pitch, roll };

std::vector<Part> parts_of_lanes(const DrivableScene& scene) {
  std::vector<Part> parts(scene.lanes.size(), Part::all);
  for (std::size_t r = 0; r < scene.routes.size(); ++r)
    for (int lane : scene.routes[r].lanes) parts[lane] = scene.route_parts[r];
  return parts;
}

}  // namespace

std::vector<UsableStretch> usable_stretches(std::span<const Lane> lanes, std::span<const Part> lane_parts) {
  std::vector<bool> is_entered(lanes.size(), false);
  for (const Lane& lane : lanes)
    for (int next : lane.next) is_entered[next] = true;
  std::vector<UsableStretch> usable;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const Lane& lane = lanes[i];
    const double whole_m = length_m(lane);
    const bool leaves_part = std::any_of(lane.next.begin(), lane.next.end(),
                                         [&](int next) { return lane_parts[next] != lane_parts[i]; });
    UsableStretch stretch{.from_m = is_entered[i] ? 0 : blind_end_m, .to_m = whole_m};
    if (leaves_part)
      stretch.to_m -= std::min(other_part_m, whole_m / 2);
    else if (lane.next.empty())
      stretch.to_m -= blind_end_m;
    stretch.to_m = std::max(stretch.to_m, stretch.from_m);
    usable.push_back(stretch);
  }
  return usable;
}

DrivableScene drivable_scene(const Scene& scene, const std::string& name, const Recipe& recipe,
                             Stream stream) {
  DrivableScene drivable{.lanes = scene.lanes,
                         .usable = {},
                         .routes = routes(scene),
                         .route_parts = {},
                         .clearance = ClearanceQuery(scene)};
  if (drivable.lanes.empty())
    throw std::runtime_error(name + ": has no lanes to drive on; give its glTF scene extras.cps_lanes");
  if (recipe.split == "thesis") {
    drivable.route_parts.assign(drivable.routes.size(), Part::all);
    drivable.usable = usable_stretches(drivable.lanes, parts_of_lanes(drivable));
    return drivable;
  }
  if (drivable.routes.size() < 3)
    throw std::runtime_error(
        name + ": has " + std::to_string(drivable.routes.size()) +
        " streets, too few for train, val and test; use split = thesis or a larger scene");
  std::vector<double> lengths;
  for (const Route& route : drivable.routes) lengths.push_back(route.length_m);
  drivable.route_parts = deal_parts(lengths, recipe.train_share, recipe.val_share, stream);
  drivable.usable = usable_stretches(drivable.lanes, parts_of_lanes(drivable));
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
      total_length_m += scene.usable[lane].length_m();
    }
  }
  for (int attempt = 0; attempt < max_attempts && total_length_m > 0; ++attempt) {
    const Stream draw = substream(stream, attempt);
    double distance_m = random_uniform(draw, along, 0, total_length_m);
    std::size_t chosen = 0;
    while (chosen + 1 < lanes.size() && distance_m > scene.usable[lanes[chosen]].length_m())
      distance_m -= scene.usable[lanes[chosen++]].length_m();
    const Lane& lane = scene.lanes[lanes[chosen]];
    DrawnPlace drawn{.street = lane.street, .place = {}, .camera = camera, .attempts = attempt + 1};
    drawn.place = place_on_lane(lane, scene.usable[lanes[chosen]].from_m + distance_m,
                                recipe.lateral_m * random_normal(draw, lateral),
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
