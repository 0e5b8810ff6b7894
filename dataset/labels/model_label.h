#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <string>

#include "distortion/crop/true_fov.h"
#include "distortion/models/model_camera.h"
#include "sampler/part.h"

namespace cps {

/// The contents of a leaf folder's calibration.json where the lens is of a family other than Brown–Conrady:
/// `model` and `params` take the place of k1 … p2, and there are no keys that only a crop has.
struct ModelLabel {
  ModelCamera camera;  ///< its name is the rig camera's
  TrueFov seen;        ///< what the image really sees
  double certificate_min_scale = 0, certificate_max_roundtrip_px = 0;
  Eigen::Isometry3d vehicle_from_camera = Eigen::Isometry3d::Identity();
  Part part = Part::train;
  std::uint64_t seed = 0;
  std::string generator;  ///< program and version
};

/// Everything of a label that follows from the camera: angles, certificate, the worst round trip of a pixel
/// (unproject, project) over a grid of the frame. Pose, part and seed are the caller's. Throws
/// std::runtime_error with one line if the lens is not proved one-to-one on the frame.
ModelLabel model_label(const ModelCamera& camera);

/// The file's keys, in the order of docs/formats.md: `schema`, then those of model_camera_json().
nlohmann::ordered_json to_json(const ModelLabel& label);

}  // namespace cps
