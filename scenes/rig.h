#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace cps {

/// Where the car stands: a point on the road (world, y up, metres) and the heading about +y,
/// 0 along world +x, growing to the left (anticlockwise from above). Vehicle frame: x forward, y left, z up
/// (ISO 8855), its origin on the road below the rear axle's centre.
struct Place {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double heading_rad = 0;
  double pitch_rad = 0;  ///< nose up positive
  double roll_rad = 0;   ///< clockwise as the driver sees it: the right side goes down
};

/// A camera bolted to the car: its position in the vehicle frame and how it is turned from looking straight
/// ahead.
struct RigCamera {
  std::string name = "front";
  Eigen::Vector3d position_m = {1.68, 0.0, 1.65};
  double yaw_deg = 0, pitch_deg = 0,
         roll_deg = 0;  ///< left, up and clockwise positive (about z, −y, x; applied in this order)
  bool is_valid(std::string* why) const;
};

/// The cameras of one car. They see every place together.
struct Rig {
  std::vector<RigCamera> cameras = {RigCamera{}};
  /// Whether there are cameras, each valid, no two of one name.
  bool is_valid(std::string* why) const;
};

/// Vehicle ← camera (x right, y down, z forward): KITTI's extrinsic.
Eigen::Isometry3d vehicle_from_camera(const RigCamera& camera);

/// World ← vehicle.
Eigen::Isometry3d world_from_vehicle(const Place& place);

}  // namespace cps
