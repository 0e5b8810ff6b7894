#include "sampler/places/place_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "distortion/pinhole.h"
#include "numbers/angles.h"
#include "sampler/places/lane_change.h"
#include "sampler/splits.h"
#include "scenes/places/clearance.h"
#include "scenes/wheels.h"

namespace cps {
namespace {

constexpr int max_place_attempts = 200;
/// Distance that places keep from the start or end of a lane that is not linked to another.
constexpr double blind_end_m = 3;
/// Distance that they keep from the end of a lane that leads into another part's; at most half the lane.
constexpr double other_part_m = 10;

/// Indices of the numbers that one attempt draws, in the attempt's stream.
enum PlaceNumber : std::uint64_t { along, lateral, heading, lane_change };
/// Indices of the numbers drawn for each camera, in a stream of its own.
enum MountNumber : std::uint64_t { yaw, pitch, roll, forward, left, up };

RigCamera with_mount_error(RigCamera camera, const Recipe& recipe, Stream draw) {
  camera.yaw_deg += recipe.mount_error_deg * random_normal(draw, yaw);
  camera.pitch_deg += recipe.mount_error_deg * random_normal(draw, pitch);
  camera.roll_deg += recipe.mount_error_deg * random_normal(draw, roll);
  camera.position_m +=
      recipe.mount_error_m *
      Eigen::Vector3d(random_normal(draw, forward), random_normal(draw, left), random_normal(draw, up));
  return camera;
}

/// Turned further by what the recipe draws for each place.
RigCamera with_drawn_turn(RigCamera camera, const Recipe& recipe, Stream draw) {
  camera.pitch_deg += random_uniform(draw, 0, recipe.camera_pitch_min_deg, recipe.camera_pitch_max_deg);
  camera.roll_deg += random_uniform(draw, 1, recipe.camera_roll_min_deg, recipe.camera_roll_max_deg);
  return camera;
}

/// The fault of the first camera that has one.
PlaceFault rig_fault(const DrivableScene& scene, const DrawnPlace& drawn, const Recipe& recipe) {
  for (const RigCamera& camera : drawn.cameras) {
    const Eigen::Isometry3d vehicle = vehicle_from_camera(camera);
    const bool looks_ahead = vehicle.linear()(0, 2) > 0.5;  // within 60° of the driving direction
    const Eigen::Isometry3d world = world_from_vehicle(drawn.place) * vehicle;
    const Eigen::Vector3d position = world.translation(), forward = world.linear().col(2);
    PlaceFault fault = clearance_fault(scene.rays, position, forward,
                                       looks_ahead ? recipe.clearance_m : recipe.side_clearance_m);
    if (fault == PlaceFault::none) fault = light_fault(scene.rays, scene.light, position, forward);
    if (fault != PlaceFault::none) return fault;
  }
  return PlaceFault::none;
}

std::vector<Part> parts_of_lanes(const DrivableScene& scene) {
  std::vector<Part> parts(scene.lanes.size(), Part::all);
  for (std::size_t r = 0; r < scene.routes.size(); ++r)
    for (int lane : scene.routes[r].lanes) parts[lane] = scene.route_parts[r];
  return parts;
}

}  // namespace

std::vector<LaneStretch> usable_stretches(std::span<const Lane> lanes, std::span<const Part> lane_parts) {
  std::vector<bool> is_entered(lanes.size(), false);
  for (const Lane& lane : lanes)
    for (int next : lane.next) is_entered[next] = true;
  std::vector<LaneStretch> usable;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const Lane& lane = lanes[i];
    const double whole_m = length_m(lane);
    const bool leaves_part = std::any_of(lane.next.begin(), lane.next.end(),
                                         [&](int next) { return lane_parts[next] != lane_parts[i]; });
    LaneStretch stretch{.from_m = is_entered[i] ? 0 : blind_end_m, .to_m = whole_m};
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
                         .traffic = traffic_on(scene.lanes),
                         .rays = SceneRays(scene),
                         .light = scene_light(scene)};
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

void PlaceTally::add(const PlaceTally& other) {
  drawn += other.drawn;
  for (std::size_t i = 0; i < faults.size(); ++i) faults[i] += other.faults[i];
}

std::string PlaceTally::brief() const {
  std::string text = fmt::format("{:.2f} % of {} places rejected",
                                 100.0 * rejected() / std::max(drawn, std::int64_t{1}), drawn);
  const char* separator = ": ";
  for (int i = 1; i < place_fault_count; ++i) {
    if (faults[i] == 0) continue;
    text += fmt::format("{}{} {}", separator, faults[i], to_string(static_cast<PlaceFault>(i)));
    separator = ", ";
  }
  return text;
}

DrawnPlace draw_place(const DrivableScene& scene, const Rig& rig, Part part, const Recipe& recipe,
                      const LaneStratum& stratum, Stream stream) {
  std::vector<int> lanes;
  double total_length_m = 0;
  for (std::size_t r = 0; r < scene.routes.size(); ++r) {
    if (scene.route_parts[r] != part && scene.route_parts[r] != Part::all) continue;
    for (int lane : scene.routes[r].lanes) {
      lanes.push_back(lane);
      total_length_m += scene.usable[lane].length_m();
    }
  }
  PlaceTally tally;
  for (int attempt = 0; attempt < max_place_attempts && total_length_m > 0; ++attempt) {
    const Stream draw = substream(stream, attempt);
    double distance_m = total_length_m * stratified(stratum, attempt, random_uniform(draw, along));
    std::size_t chosen = 0;
    while (chosen + 1 < lanes.size() && distance_m > scene.usable[lanes[chosen]].length_m())
      distance_m -= scene.usable[lanes[chosen++]].length_m();
    const Lane& lane = scene.lanes[lanes[chosen]];
    distance_m += scene.usable[lanes[chosen]].from_m;
    DrawnPlace drawn{.street = lane.street, .place = {}, .cameras = {}, .tally = {}};
    LaneOffset offset{.lateral_m = recipe.lateral_m * random_normal(draw, lateral),
                      .yaw_rad = radians(recipe.heading_deg) * random_normal(draw, heading)};
    if (random_uniform(draw, lane_change) < recipe.lane_change_share)
      offset +=
          draw_lane_change(scene.lanes, lanes[chosen], distance_m, make_stream(draw.key, "lane change"));
    drawn.place = on_wheels(scene.rays, place_on_lane(lane, distance_m, offset.lateral_m, offset.yaw_rad));
    if (!is_clear_of(scene.traffic, drawn.place)) continue;
    for (std::size_t c = 0; c < rig.cameras.size(); ++c)
      drawn.cameras.push_back(with_drawn_turn(
          with_mount_error(rig.cameras[c], recipe, substream(make_stream(draw.key, "mount"), c)), recipe,
          substream(make_stream(draw.key, "turn"), c)));
    const PlaceFault fault = rig_fault(scene, drawn, recipe);
    ++tally.drawn;
    ++tally.faults[static_cast<int>(fault)];
    drawn.tally = tally;
    if (fault == PlaceFault::none) return drawn;
  }
  throw std::runtime_error(
      fmt::format("no place for part {}: {}; lower clearance_m, or use a scene with longer lanes",
                  to_string(part), tally.brief()));
}

}  // namespace cps
