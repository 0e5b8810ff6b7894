#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dataset/exchange/formats/coefficients.h"
#include "dataset/exchange/lens_names.h"
#include "dataset/exchange/model_calibration.h"
#include "files/json_keys.h"

/// The formats of calibration_file.h, one source file each. The text of every format but the line-based ones
/// is first made into JSON (markup.h). To add a format: a reader here, its line in `read_keys` or `read_any`
/// (model_calibration.cpp), a writer and what it can hold in write_calibration.cpp, a row in docs/formats.md,
/// a value check in tests/dataset/exchange. Readers throw std::runtime_error in one line, `<file>: <key>: …`;
/// those of files with several cameras keep what one camera throws and read the others. `name`: of a camera
/// that the format leaves nameless.
namespace cps {

using CameraSpan = std::span<const ModelCamera>;

ModelCamera read_cps(const JsonKeys& root, const std::string& name);
std::string write_cps(CameraSpan cameras);

/// cv::FileStorage as OpenCV's samples write it, OpenCV 2.4's capitals, and the same as Python's nested
/// lists.
ModelCamera read_opencv(const JsonKeys& root, const std::string& name);
bool is_opencv(const nlohmann::json& json);
std::string write_opencv_yaml(CameraSpan cameras);
std::string write_opencv_xml(CameraSpan cameras);

/// The YAML of camera_calibration_parsers, and a camera_info message as `topic echo` prints it.
ModelCamera read_ros(const JsonKeys& root, const std::string& name);
ModelCamera read_ros_message(const JsonKeys& root, const std::string& name);
std::string write_ros(CameraSpan cameras);

ModelCalibrationFile read_kalibr(const JsonKeys& root);
std::string write_kalibr(CameraSpan cameras);

/// EuRoC's sensor.yaml.
ModelCamera read_euroc(const JsonKeys& root, const std::string& name);

/// ORB-SLAM 2 and 3: `Camera.fx`, `Camera1.fx`, `Camera2.fx`.
ModelCalibrationFile read_orbslam(const JsonKeys& root);
bool is_orbslam(const nlohmann::json& json);

/// VINS and camodocal: `projection_parameters`, `distortion_parameters`.
ModelCamera read_vins(const JsonKeys& root, const std::string& name);

ModelCalibrationFile read_nerfstudio(const JsonKeys& root, const std::string& name);
std::string write_nerfstudio(CameraSpan cameras);
/// The keys that describe a Brown–Conrady camera, of the whole file or of one frame.
nlohmann::ordered_json nerfstudio_camera(const CalibratedCamera& camera);

/// Agisoft Metashape's <calibration>.
ModelCamera read_metashape(const JsonKeys& root, const std::string& name);

ModelCalibrationFile read_colmap(const std::string& text, const std::string& file);
std::string write_colmap(CameraSpan cameras);

/// KITTI raw and KITTI-360 (S_00, K_00, D_00).
ModelCalibrationFile read_kitti(const std::string& text, const std::string& file);
bool is_kitti(const std::string& text);
std::string write_kitti(CameraSpan cameras);

/// KITTI odometry's calib.txt (P0 … P3): rectified, so without distortion, and without sizes.
ModelCalibrationFile read_kitti_odometry(const std::string& text, const std::string& file);
bool is_kitti_odometry(const std::string& text);

/// Adds what `read` returns, or why it throws.
void add_camera(ModelCalibrationFile& file, const std::string& name,
                const std::function<ModelCamera()>& read);

/// The numbers of a list, nested lists one after the other. Throws `<where>: …`, saying what is no number.
std::vector<double> number_list(const nlohmann::json& list, const std::string& where);
/// The same of as many numbers as `count` says.
std::vector<double> number_list(const nlohmann::json& list, std::size_t count, const std::string& where);

/// A size in pixels, whole, whether it is written 640 or 640.0.
int size_px(double value, const std::string& where);

/// Text, or a number as it is written: people name cameras by serial numbers.
std::string name_at(const JsonKeys& keys, const std::string& key);

/// fx, fy, cx, cy of a row-major 3 × 3 matrix; throws `<where>: …` unless it is [fx 0 cx; 0 fy cy; 0 0 1].
Pinhole pinhole_from_k(std::span<const double> k, int width, int height, const std::string& where);

/// The shortest decimal that reads back to the same bits, always with a point or an exponent.
std::string decimal(double value);
/// Separated by `separator`.
std::string decimals(std::span<const double> values, const std::string& separator);
/// The row-major 3 × 3 matrix of a camera.
std::vector<double> k_matrix(const Pinhole& camera);

/// The only camera, for formats that hold one; throws std::runtime_error if there are more.
const ModelCamera& only_camera(CameraSpan cameras);

}  // namespace cps
