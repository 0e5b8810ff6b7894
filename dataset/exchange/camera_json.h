#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "distortion/calibrated_camera.h"
#include "distortion/models/model_camera.h"
#include "files/json_keys.h"

/// The keys of calibration.json that describe the camera. Published readers of CPS datasets know only these.
namespace cps {

/// The keys fov K width height k1 k2 k3 p1 p2 cx cy.
nlohmann::ordered_json camera_json(const Pinhole& camera, const Distortion& lens);

/// The rows of a pose's matrix: all four, or the first three.
nlohmann::ordered_json rows_json(const Eigen::MatrixX4d& rows);

/// The camera from K, width, height and the coefficients. fov, cx and cy follow from them and may be missing.
/// Throws as JsonKeys does.
CalibratedCamera camera_from_json(const JsonKeys& keys);

/// As camera_json() for Brown–Conrady. Other families: the keys model params K width height, where `params`
/// names the family's parameters. There is no k1 then, so readers that know only Brown–Conrady stop.
nlohmann::ordered_json model_camera_json(const Pinhole& camera, const LensModel& lens);

/// The camera from either set of keys; all parameters of the family must be given. Throws as JsonKeys does;
/// refuses coefficients that stand beside `params`.
ModelCamera model_camera_from_json(const JsonKeys& keys);

}  // namespace cps
