#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "distortion/calibrated_camera.h"
#include "distortion/image_size.h"

namespace cps {

/// File formats of camera calibrations, that of this project and of others. docs/formats.md describes them.
enum class CalibrationFormat { cps, opencv_yaml, opencv_xml, colmap, ros, kitti, kalibr, nerfstudio };

/// "cps", "opencv-yaml", … and back. Throws std::runtime_error that lists the known names.
std::string to_string(CalibrationFormat format);
CalibrationFormat calibration_format_from_string(const std::string& name);

/// The file name that readers of the format expect: "cameras.txt", …
std::string usual_file_name(CalibrationFormat format);

/// A camera that the file names but whose numbers cannot be read as Brown–Conrady.
struct UnreadCamera {
  std::string name;
  std::string fault;  ///< one line, `<file>: <camera or field>: <what is wrong>`
};

/// The cameras of a file. One that cannot be read does not hide the others.
struct CalibrationFile {
  std::vector<CalibratedCamera> cameras = {};
  std::vector<UnreadCamera> unread = {};
};

/// The cameras of a file of any of these formats, told apart by their contents. Centres of pixels are
/// converted to ours. A camera that the format leaves nameless is named after the file. `size`: of the
/// pictures, for formats that do not say it (KITTI odometry, ORB-SLAM 2). Throws std::runtime_error in one
/// line, `<file>: <camera or field>: <what is wrong>`, if no camera can be read; refuses unknown formats,
/// models that are not Brown–Conrady, non-zero coefficients beyond k1 k2 k3 p1 p2, skew, keys that appear
/// twice, numbers that are not finite or beyond any lens, absurd sizes, a principal point outside the image.
CalibrationFile read_calibration_file(const std::filesystem::path& file, ImageSize size = {0, 0});

/// All cameras of the file; throws as well if one of them cannot be read.
std::vector<CalibratedCamera> read_calibration(const std::filesystem::path& file, ImageSize size = {0, 0});

/// The camera of this name, whatever the file's other cameras are; without a name, the only one. Throws
/// std::runtime_error listing the names that there are.
CalibratedCamera read_camera(const std::filesystem::path& file, const std::string& name,
                             ImageSize size = {0, 0});

/// Writes the file completely or not at all. Reading it gives `cameras` back to the last bit, except for cx
/// and cy in formats that shift them by half a pixel (colmap, nerfstudio: one unit in the last place). Throws
/// std::runtime_error when the format cannot hold the cameras: k3 in Kalibr's radtan, or several cameras in a
/// format for one.
void write_calibration(const std::filesystem::path& file, CalibrationFormat format,
                       std::span<const CalibratedCamera> cameras);

}  // namespace cps
