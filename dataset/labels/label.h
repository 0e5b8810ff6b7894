#pragma once

#include <Eigen/Geometry>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"
#include "files/json_keys.h"
#include "numbers/interval.h"
#include "sampler/part.h"

namespace cps {

/// The contents of a leaf folder's calibration.json: its images share size, rig camera, base H-FOV and lens.
struct Label {
  Pinhole camera;  ///< of the final image; fx = fy; hfov_rad(camera) is the label's `fov`
  Distortion distortion;
  double fov_base_deg = 0;  ///< the master's H-FOV, before the crop
  /// What the distorted image really sees: horizontal and vertical through the principal point, diagonal
  /// corner to corner.
  double fov_true_h_deg = 0, fov_true_v_deg = 0, fov_true_d_deg = 0;
  double zoom = 1;  ///< of the crop
  double certificate_min_eigenvalue = 0, certificate_max_roundtrip_px = 0;
  /// The interval that each number was drawn from, in the order of lens_keys; empty for numbers drawn
  /// together, and for the undistorted group.
  std::array<std::optional<Interval>, 7> limits;
  std::string rig_camera;
  Eigen::Isometry3d vehicle_from_camera = Eigen::Isometry3d::Identity();
  Part part = Part::train;
  std::uint64_t seed = 0;
  std::string generator;  ///< program and version
};

/// The undistorted camera before the crop: of the image's size, with a centred principal point. The lens is
/// certified on its frame.
Pinhole base_of(const Label& label);

/// Unit vector of gravity (downwards) in the camera frame, for the rig camera's nominal pose on level ground.
Eigen::Vector3d nominal_gravity(const Eigen::Isometry3d& vehicle_from_camera);
inline Eigen::Vector3d nominal_gravity(const Label& label) {
  return nominal_gravity(label.vehicle_from_camera);
}

/// The form that calibration.json, frames.csv and dataset.json are written in; `schema` in both JSON files.
/// Schema 1 is the same without gravity.
inline constexpr int label_schema = 2;

/// The file's schema. Throws as JsonKeys does for a number that is neither 1 nor 2.
int schema_of(const JsonKeys& keys);

/// Keys of labels of all families. Throw as label_from_json() does: `gravity` must follow from
/// T_vehicle_camera.
void check_gravity(const JsonKeys& keys, const Eigen::Isometry3d& vehicle_from_camera);
Part part_of_label(const JsonKeys& keys);

/// The keys of these seven numbers, both in the label and in its `limits`.
inline constexpr std::array<const char*, 7> lens_keys = {"k1", "k2", "k3", "p1", "p2", "cx", "cy"};

/// `schema`: 1 gives what older programs wrote.
nlohmann::ordered_json to_json(const Label& label, int schema = label_schema);

/// Throws std::runtime_error with one line that starts with `file` and names the key when one is missing, of
/// the wrong type, or contradicts another (K against fov, cx, cy; gravity against T_vehicle_camera). Reads
/// all schemas. Refuses a label of another lens family by the family's name.
Label label_from_json(const nlohmann::json& json, const std::string& file);

}  // namespace cps
