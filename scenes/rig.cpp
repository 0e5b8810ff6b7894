#include "scenes/rig.h"

#include <cmath>

#include "numbers/angles.h"

namespace cps {
namespace {

/// Camera names become folder names.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name.size() <= 64 &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
             std::string::npos;
}

}  // namespace

std::string RigCamera::fault() const {
  if (!is_plain_name(name)) return "name = \"" + name + "\" must be 1 to 64 letters, digits, - or _";
  if (!(position_m.norm() <= 50)) return "position_m must lie within 50 m of the car's origin";
  if (!(std::abs(yaw_deg) <= 180)) return "yaw_deg must be within -180 and 180";
  if (!(std::abs(pitch_deg) <= 90)) return "pitch_deg must be within -90 and 90";
  if (!(std::abs(roll_deg) <= 180)) return "roll_deg must be within -180 and 180";
  return "";
}

std::string Rig::fault() const {
  if (cameras.empty()) return "has no camera";
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (const std::string fault = cameras[i].fault(); !fault.empty()) return cameras[i].name + ": " + fault;
    for (std::size_t j = 0; j < i; ++j)
      if (cameras[j].name == cameras[i].name) return cameras[i].name + ": is the name of two cameras";
  }
  return "";
}

Eigen::Isometry3d vehicle_from_camera(const RigCamera& camera) {
  Eigen::Matrix3d straight_ahead;  // columns: where the camera's x (right), y (down) and z (forward) point
  straight_ahead << 0, 0, 1,       //
      -1, 0, 0,                    //
      0, -1, 0;
  return Eigen::Translation3d(camera.position_m) *
         Eigen::AngleAxisd(radians(camera.yaw_deg), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(radians(camera.pitch_deg), -Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(radians(camera.roll_deg), Eigen::Vector3d::UnitX()) *
         Eigen::Isometry3d(straight_ahead);
}

Eigen::Isometry3d world_from_vehicle(const Place& place) {
  Eigen::Matrix3d heading_east;  // columns: where the vehicle's x (forward), y (left) and z (up) point
  heading_east << 1, 0, 0,       //
      0, 0, 1,                   //
      0, -1, 0;
  return Eigen::Translation3d(place.position) *
         Eigen::AngleAxisd(place.heading_rad, Eigen::Vector3d::UnitY()) * Eigen::Isometry3d(heading_east) *
         Eigen::AngleAxisd(place.pitch_rad, -Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(place.roll_rad, Eigen::Vector3d::UnitX());
}

}  // namespace cps
