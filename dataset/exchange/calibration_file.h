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

/// All of them.
std::span<const CalibrationFormat> calibration_formats();

/// The file name that readers of the format expect: "cameras.txt", …
std::string usual_file_name(CalibrationFormat format);

/// A camera that the file names but whose numbers cannot be read.
struct UnreadCamera {
  std::string name;
  std::string fault;  ///< one line, `<file>: <camera or field>: <what is wrong>`
};

/// All Brown–Conrady cameras of the file, read as read_model_calibration_file() (model_calibration.h) does.
/// Throws as it does, and also if one of the cameras cannot be read or is of another lens family.
std::vector<CalibratedCamera> read_calibration(const std::filesystem::path& file, ImageSize size = {0, 0});

/// The Brown–Conrady camera of this name, whatever the file's other cameras are; without a name, the only
/// one. Throws std::runtime_error listing the names that there are, or naming the lens family that it is of.
CalibratedCamera read_camera(const std::filesystem::path& file, const std::string& name,
                             ImageSize size = {0, 0});

/// Writes the file completely or not at all. Reading it gives `cameras` back to the last bit, except for cx
/// and cy in formats that shift them by half a pixel (colmap, nerfstudio: one unit in the last place). Throws
/// std::runtime_error when the format cannot hold the cameras: k3 in Kalibr's radtan, or several cameras in a
/// format for one.
void write_calibration(const std::filesystem::path& file, CalibrationFormat format,
                       std::span<const CalibratedCamera> cameras);

}  // namespace cps
