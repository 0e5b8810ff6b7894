#include "dataset/report/frame_distributions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numbers/angles.h"

namespace cps {
namespace {

using Pose = Eigen::Isometry3d;

/// A number of a line of frames.csv. `camera`: world from camera; `error`: from the camera as it was meant to
/// sit on the car to the camera as it sits.
struct FrameNumber {
  const char *name, *unit;
  double (*of)(const FrameRow& row, const Pose& camera, const Pose& error);
  std::optional<Interval> (*limits)(const Recipe& recipe);  ///< nullptr: none
  std::string (*note)(const Recipe& recipe);
};

std::string no_note(const Recipe&) {
  return "";
}
std::string mount_angle_note(const Recipe& recipe) {
  return fmt::format("Recipe: normal, standard deviation {:g}", recipe.mount_error_deg);
}
std::string turned_note(const Recipe& recipe, double min_deg, double max_deg) {
  if (min_deg == 0 && max_deg == 0) return mount_angle_note(recipe);
  return mount_angle_note(recipe) + fmt::format(", and uniform in {:g} … {:g}", min_deg, max_deg);
}
std::string mount_pitch_note(const Recipe& recipe) {
  return turned_note(recipe, recipe.camera_pitch_min_deg, recipe.camera_pitch_max_deg);
}
std::string mount_roll_note(const Recipe& recipe) {
  return turned_note(recipe, recipe.camera_roll_min_deg, recipe.camera_roll_max_deg);
}
std::string mount_offset_note(const Recipe& recipe) {
  return fmt::format("Recipe: normal along each axis, standard deviation {:g} mm",
                     1000 * recipe.mount_error_m);
}

double turned_deg(const Pose& error, int axis) {
  const Eigen::AngleAxisd turn(error.linear());
  return degrees(turn.angle() * turn.axis()[axis]);
}

constexpr FrameNumber frame_numbers[] = {
    {"vehicle heading", "degrees, 0 along +x (east), to the left",
     [](const FrameRow& row, const Pose&, const Pose&) {
       return std::remainder(degrees(row.vehicle.heading_rad), 360.0);
     },
     nullptr, no_note},
    {"vehicle pitch", "degrees, nose up",
     [](const FrameRow& row, const Pose&, const Pose&) { return degrees(row.vehicle.pitch_rad); }, nullptr,
     no_note},
    {"vehicle roll", "degrees, right side down",
     [](const FrameRow& row, const Pose&, const Pose&) { return degrees(row.vehicle.roll_rad); }, nullptr,
     no_note},
    {"ground height under the vehicle", "m",
     [](const FrameRow& row, const Pose&, const Pose&) { return row.vehicle.position.y(); }, nullptr,
     no_note},
    {"camera height over that ground", "m",
     [](const FrameRow& row, const Pose&, const Pose&) {
       return row.camera_position.y() - row.vehicle.position.y();
     },
     nullptr, no_note},
    {"camera pitch", "degrees above the horizon",
     [](const FrameRow&, const Pose& camera, const Pose&) {
       return degrees(std::asin(std::clamp(camera.linear()(1, 2), -1.0, 1.0)));
     },
     nullptr, no_note},
    {"camera roll", "degrees, right side down",
     [](const FrameRow&, const Pose& camera, const Pose&) {
       return degrees(std::atan2(-camera.linear()(1, 0), -camera.linear()(1, 1)));
     },
     nullptr, no_note},
    {"mount error about the camera's x axis", "degrees, up",
     [](const FrameRow&, const Pose&, const Pose& error) { return turned_deg(error, 0); }, nullptr,
     mount_pitch_note},
    {"mount error about the camera's y axis", "degrees, to the right",
     [](const FrameRow&, const Pose&, const Pose& error) { return turned_deg(error, 1); }, nullptr,
     mount_angle_note},
    {"mount error about the camera's z axis", "degrees, clockwise",
     [](const FrameRow&, const Pose&, const Pose& error) { return turned_deg(error, 2); }, nullptr,
     mount_roll_note},
    {"distance from the mount", "mm",
     [](const FrameRow&, const Pose&, const Pose& error) { return 1000 * error.translation().norm(); },
     nullptr, mount_offset_note},
    {"metered exposure", "stops: log2 of the share of white per unit of radiance",
     [](const FrameRow& row, const Pose&, const Pose&) { return std::log2(row.exposure); }, nullptr, no_note},
    {"exposure bias", "stops",
     [](const FrameRow& row, const Pose&, const Pose&) { return row.sensor.exposure_bias_ev; },
     [](const Recipe& r) {
       return std::optional(Interval{r.sensor.exposure_bias_min_ev, r.sensor.exposure_bias_max_ev});
     },
     no_note},
    {"full well", "electrons",
     [](const FrameRow& row, const Pose&, const Pose&) { return row.sensor.full_well_e; },
     [](const Recipe& r) {
       const auto of_image = [&](double e) {
         return binned({.full_well_e = e}, r.sensor.binning).full_well_e;
       };
       return std::optional(Interval{of_image(r.sensor.full_well_min_e), of_image(r.sensor.full_well_max_e)});
     },
     no_note},
    {"read noise", "electrons, rms",
     [](const FrameRow& row, const Pose&, const Pose&) { return row.sensor.read_noise_e; },
     [](const Recipe& r) {
       const auto of_image = [&](double e) {
         return binned({.read_noise_e = e}, r.sensor.binning).read_noise_e;
       };
       return std::optional(
           Interval{of_image(r.sensor.read_noise_min_e), of_image(r.sensor.read_noise_max_e)});
     },
     no_note},
};

}  // namespace

std::vector<Distribution> frame_distributions(const Recipe& recipe) {
  std::vector<Distribution> distributions;
  for (const FrameNumber& number : frame_numbers)
    distributions.push_back({.name = number.name,
                             .unit = number.unit,
                             .limits = number.limits ? number.limits(recipe) : std::nullopt,
                             .note = number.note(recipe)});
  return distributions;
}

void add_frame(std::vector<Distribution>& distributions, const FrameRow& row, const Label& label) {
  const Pose camera = world_from_camera(row),
             error = (world_from_vehicle(row.vehicle) * label.vehicle_from_camera).inverse() * camera;
  for (std::size_t i = 0; i < distributions.size(); ++i)
    if (const double value = frame_numbers[i].of(row, camera, error); std::isfinite(value))
      distributions[i].add(row.part, value);
}

}  // namespace cps
