#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "distortion/calibrated_camera.h"

namespace cps {

/// File formats of camera calibrations, that of this project and of others. docs/formats.md describes them.
enum class CalibrationFormat { cps, opencv_yaml, opencv_xml, colmap, ros, kitti, kalibr, nerfstudio };

/// "cps", "opencv-yaml", … and back. Throws std::runtime_error that lists the known names.
std::string to_string(CalibrationFormat format);
CalibrationFormat calibration_format_from_string(const std::string& name);

/// The file name that readers of the format expect: "cameras.txt", …
std::string usual_file_name(CalibrationFormat format);

/// Reads the cameras of a file in any of these formats, which is detected from the contents. Pixel
/// coordinates are converted to this project's convention (centre of the top-left pixel at 0, 0). A camera
/// without a name in the file is named after the file. Throws std::runtime_error with one line, `<file>:
/// <camera or field>: <what is wrong>`, for unknown formats, models other than Brown–Conrady, non-zero
/// coefficients beyond k1 k2 k3 p1 p2, skew, NaN, focal lengths that are not positive, impossible sizes, a
/// principal point outside the image.
std::vector<CalibratedCamera> read_calibration(const std::filesystem::path& file);

/// Writes the file completely or not at all. Reading it gives `cameras` back to the last bit, except for cx
/// and cy in formats that shift them by half a pixel (colmap, nerfstudio: one unit in the last place). Throws
/// std::runtime_error when the format cannot hold the cameras: k3 in Kalibr's radtan, or several cameras in a
/// format for one.
void write_calibration(const std::filesystem::path& file, CalibrationFormat format,
                       std::span<const CalibratedCamera> cameras);

/// The camera of this name, or the only one if the name is empty. Otherwise throws std::runtime_error that
/// lists the cameras of the file.
CalibratedCamera chosen_camera(const std::vector<CalibratedCamera>& cameras, const std::string& name,
                               const std::filesystem::path& file);

}  // namespace cps
