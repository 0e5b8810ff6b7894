#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace cps {

/// The car's pose: a point on the road (world, y up, metres) and the heading about +y, 0 along world +x,
/// anticlockwise seen from above. Vehicle frame: x forward, y left, z up (ISO 8855), its origin on the road
/// below the rear axle's centre.
struct Place {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double heading_rad = 0;
  double pitch_rad = 0;  ///< positive: nose up
  double roll_rad = 0;   ///< positive: right side down
};

/// A camera fixed to the car: its position in the vehicle frame and its rotation from looking straight ahead.
struct RigCamera {
  std::string name = "front";
  Eigen::Vector3d position_m = {1.68, 0.0, 1.65};
  double yaw_deg = 0, pitch_deg = 0,
         roll_deg = 0;  ///< left, up and clockwise positive (about z, −y, x; applied in this order)
  /// Empty if the camera is usable; otherwise one line that names the field and its range.
  std::string fault() const;
};

/// The cameras of one car. At every place each of them takes a view.
struct Rig {
  std::vector<RigCamera> cameras = {RigCamera{}};
  /// Empty if there are cameras, each usable, no two of one name; otherwise one line that names the camera.
  std::string fault() const;
};

/// The transform vehicle ← camera (x right, y down, z forward), as in KITTI's extrinsics.
Eigen::Isometry3d vehicle_from_camera(const RigCamera& camera);

/// The transform world ← vehicle.
Eigen::Isometry3d world_from_vehicle(const Place& place);

/// The unit vector of gravity (downwards) in the frame of a camera with this orientation, world ← camera.
inline Eigen::Vector3d gravity_in_camera(const Eigen::Matrix3d& world_from_camera) {
  return Eigen::Vector3d::Zero() - world_from_camera.row(1).transpose();  // world y is up; never −0
}

}  // namespace cps
