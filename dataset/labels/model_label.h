#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <string>

#include "dataset/labels/label.h"
#include "distortion/models/model_camera.h"
#include "distortion/models/warp/model_view.h"
#include "sampler/part.h"

namespace cps {

/// The contents of a leaf folder's calibration.json where the lens is of a family other than Brown–Conrady:
/// `model` and `params` take the place of k1 … p2, and there are no keys that only a crop has.
struct ModelLabel {
  ModelCamera camera;  ///< its name is the rig camera's
  SeenAngles seen;     ///< what the image really sees
  double certificate_min_scale = 0, certificate_max_roundtrip_px = 0;
  double max_angle_rad = 0;  ///< off the axis, to which the lens is proved; written where there is a mask
  std::string valid = {};  ///< file of the mask (valid_mask.h) beside the label; empty: all pixels are valid
  Eigen::Isometry3d vehicle_from_camera = Eigen::Isometry3d::Identity();
  Part part = Part::train;
  std::uint64_t seed = 0;
  std::string generator;  ///< program and version
};

/// Everything of a label that follows from the camera: angles, certificate, the worst round trip of a pixel
/// (unproject, project) over a grid of the frame. Pose, part and seed are the caller's. Throws
/// std::runtime_error with one line if the lens is not proved one-to-one on the frame.
ModelLabel model_label(const ModelCamera& camera);

/// The same of a camera whose images have a mask: angles and certificate are those of the region that is
/// proved, which need not hold the whole frame. Throws std::runtime_error with one line if nothing is proved.
ModelLabel masked_model_label(const ModelCamera& camera);

/// The file's keys, in the order of docs/formats.md: `schema`, then those of model_camera_json(). An angle
/// that the image does not see is null.
nlohmann::ordered_json to_json(const ModelLabel& label);

/// Throws std::runtime_error with one line that starts with `file` and names the key when one is missing, of
/// the wrong type, or contradicts another (gravity against T_vehicle_camera). The lens is not proved again.
ModelLabel model_label_from_json(const nlohmann::json& json, const std::string& file);

/// What labels of all families have in common: size, focal lengths and principal point, rig camera, part,
/// seed and generator. All that only Brown–Conrady labels have is left as it is by default.
Label common_label(const ModelLabel& label);

/// Keys of the dataset.json of a dataset of this family: `model`, `is_cps` (false) and a `note` for people.
nlohmann::ordered_json other_family_json(const std::string& family);

}  // namespace cps
