#pragma once

#include <span>
#include <string>
#include <vector>

#include "distortion/calibrated_camera.h"
#include "files/json_keys.h"

/// Readers and writers of the formats in calibration_file.h, one source file each. YAML and XML are first
/// converted to JSON (markup.h), so JsonKeys checks them all; COLMAP and KITTI are read line by line. `file`
/// is for error messages.
namespace cps {

using Cameras = std::vector<CalibratedCamera>;
using CameraSpan = std::span<const CalibratedCamera>;

Cameras read_cps(const JsonKeys& root, const std::string& name);
std::string write_cps(CameraSpan cameras);

Cameras read_opencv(const JsonKeys& root, const std::string& name);
std::string write_opencv_yaml(CameraSpan cameras);
std::string write_opencv_xml(CameraSpan cameras);

Cameras read_ros(const JsonKeys& root, const std::string& name);
std::string write_ros(CameraSpan cameras);

Cameras read_kalibr(const JsonKeys& root);
std::string write_kalibr(CameraSpan cameras);

Cameras read_nerfstudio(const JsonKeys& root, const std::string& name);
std::string write_nerfstudio(CameraSpan cameras);

Cameras read_colmap(const std::string& text, const std::string& file);
std::string write_colmap(CameraSpan cameras);

Cameras read_kitti(const std::string& text, const std::string& file);
std::string write_kitti(CameraSpan cameras);

/// Coefficients from the order of OpenCV's vector, k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 tau_x tau_y; `values`
/// may hold only the first ones. Throws std::runtime_error `<where>: <name>: …` for a non-zero one after k3.
Distortion from_opencv_order(std::span<const double> values, const std::string& where);
std::vector<double> in_opencv_order(const Distortion& lens);

/// The camera of a row-major 3 × 3 matrix; throws std::runtime_error `<where>: …` unless it is
/// [fx 0 cx; 0 fy cy; 0 0 1].
Pinhole pinhole_from_k(std::span<const double> k, int width, int height, const std::string& where);

/// The shortest decimal that reads back to the same bits, always with a point or an exponent.
std::string decimal(double value);
/// The same of several numbers, with `separator` between them.
std::string decimals(std::span<const double> values, const std::string& separator);
/// The row-major 3 × 3 matrix of a camera.
std::vector<double> k_matrix(const Pinhole& camera);

/// The only camera, for formats that hold one. Throws std::runtime_error unless there is exactly one.
const CalibratedCamera& only_camera(CameraSpan cameras);

}  // namespace cps
