#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "dataset/exchange/calibration_file.h"
#include "distortion/image_size.h"
#include "distortion/models/model_camera.h"

/// Calibrations of cameras of any lens family, in the formats of calibration_file.h.
namespace cps {

/// The cameras of a file. One that cannot be read does not hide the others.
struct ModelCalibrationFile {
  std::vector<ModelCamera> cameras = {};
  std::vector<UnreadCamera> unread = {};
};

/// The cameras of a file of any of these formats, told apart by their contents; each camera has the family
/// that the file names or that its keys imply. Centres of pixels are converted to ours. A camera that the
/// format leaves nameless is named after the file. `size`: of the pictures, for formats that do not say it
/// (KITTI odometry, ORB-SLAM 2). Throws std::runtime_error in one line, `<file>: <camera or field>: <what is
/// wrong>`, if no camera can be read; refuses unknown formats and models, files that could be of two
/// families, non-zero coefficients that the family lacks, skew, keys that appear twice, numbers that are not
/// finite or beyond any lens, absurd sizes, a principal point outside the image.
ModelCalibrationFile read_model_calibration_file(const std::filesystem::path& file, ImageSize size = {0, 0});

/// The camera of this name, whatever the file's other cameras are; without a name, the only one. Throws
/// std::runtime_error listing the names that there are.
ModelCamera read_model_camera(const std::filesystem::path& file, const std::string& name,
                              ImageSize size = {0, 0});

/// Writes the file completely or not at all, as write_calibration() does. Brown–Conrady cameras give the same
/// bytes as there. Reading it gives `cameras` back to the last bit, with the same exceptions, and a rational
/// lens whose k4 k5 k6 are 0 comes back as Brown–Conrady, the same lens, in formats other than cps. Throws
/// std::runtime_error when the format cannot hold a camera's family (the line names the formats that can),
/// or several cameras in a format for one.
void write_model_calibration(const std::filesystem::path& file, CalibrationFormat format,
                             std::span<const ModelCamera> cameras);

/// Whether the format can say this lens: its family and, where the format leaves out coefficients of it,
/// those are 0.
bool can_hold(CalibrationFormat format, const LensModel& lens);

}  // namespace cps
