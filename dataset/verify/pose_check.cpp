#include "dataset/verify/pose_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "dataset/job/recipe_json.h"
#include "numbers/angles.h"

namespace cps {
namespace {

/// Rounding of poses kilometres from the origin, in metres and radians; of a quaternion's length; of gravity.
constexpr double rounding = 1e-6;

/// Empty when nothing is wrong.
std::string pose_fault(const FrameRow& frame, const Label& label, const Recipe& recipe) {
  constexpr double deviations = 8;
  // Errors of yaw, pitch and roll add up at worst: to √3 times their root sum of squares. A turn changes the
  // pitch and the roll of the nominal pose, each by itself.
  const double max_turn_deg =
      std::max(std::abs(recipe.camera_pitch_min_deg), std::abs(recipe.camera_pitch_max_deg)) +
      std::max(std::abs(recipe.camera_roll_min_deg), std::abs(recipe.camera_roll_max_deg));
  const double max_angle_rad = deviations * std::numbers::sqrt3 * radians(recipe.mount_error_deg) +
                               radians(max_turn_deg) + rounding,
               max_offset_m = deviations * recipe.mount_error_m + rounding;
  if (std::abs(frame.camera_rotation.norm() - 1) > rounding) return "camera_qw…qz: is no unit quaternion";
  if (!((frame.gravity - gravity_by_pose(frame)).norm() <= rounding))
    return "gravity_x…z: contradicts camera_qw…qz";
  const Eigen::Isometry3d meant = world_from_vehicle(frame.vehicle) * label.vehicle_from_camera,
                          error = meant.inverse() * world_from_camera(frame);
  const double angle_rad = Eigen::AngleAxisd(error.linear()).angle(), offset_m = error.translation().norm();
  if (angle_rad <= max_angle_rad && offset_m <= max_offset_m) return "";
  return fmt::format(
      "its camera is turned by {:.3g}° and lies {:.3g} m off T_vehicle_camera on the vehicle's pose",
      degrees(angle_rad), offset_m);
}

}  // namespace

void check_poses(const DatasetFiles& files, Faults& faults) try {
  if (!files.description) return;
  const Recipe recipe = read_recipe(files.dataset.root);
  for (const DatasetImage& image : files.dataset.images)
    if (const FrameRow* frame = files.frame_of(image.file)) {
      const std::string fault = pose_fault(*frame, files.dataset.groups[image.group].label, recipe);
      if (!fault.empty()) faults.push_back(image.file.string() + ": " + fault);
    }
} catch (const std::runtime_error& error) {
  faults.push_back(error.what());
}

}  // namespace cps
