#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "distortion/calibrated_camera.h"

namespace cps {

/// Files that describe cameras, ours and other people's. docs/formats.md says what each holds.
enum class CalibrationFormat { cps, opencv_yaml, opencv_xml, colmap, ros, kitti, kalibr, nerfstudio };

/// "cps", "opencv-yaml", … and back. Throws std::runtime_error naming the ones there are.
std::string to_string(CalibrationFormat format);
CalibrationFormat calibration_format_from_string(const std::string& name);

/// What programs that read the format look for: "cameras.txt", …
std::string usual_file_name(CalibrationFormat format);

/// The cameras of a file of any of these formats, told apart by what it says. Centres of pixels are converted
/// to ours. A camera that the format leaves nameless is named after the file. Throws std::runtime_error in
/// one line, `<file>: <camera or field>: <what is wrong>`: unknown formats, models that are not
/// Brown–Conrady, non-zero coefficients beyond k1 k2 k3 p1 p2, skew, NaN, focal lengths that are not
/// positive, absurd sizes, a principal point outside the image.
std::vector<CalibratedCamera> read_calibration(const std::filesystem::path& file);

/// Writes the file whole or not at all. What is read back equals `cameras` to the last bit, but for cx and cy
/// in formats that shift them by half a pixel (colmap, nerfstudio: one unit in the last place). Throws
/// std::runtime_error where the format cannot say it: k3 in Kalibr's radtan, several cameras in a file for
/// one.
void write_calibration(const std::filesystem::path& file, CalibrationFormat format,
                       std::span<const CalibratedCamera> cameras);

/// The camera of this name; without a name, the only one. Throws std::runtime_error listing those there are.
CalibratedCamera chosen_camera(const std::vector<CalibratedCamera>& cameras, const std::string& name,
                               const std::filesystem::path& file);

}  // namespace cps
