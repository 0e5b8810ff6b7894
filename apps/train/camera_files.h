#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "dataset/exchange/calibration_file.h"
#include "distortion/models/model_camera.h"

/// Calibration files of predicted cameras, as `--format` of `cps predict` asks for them.
namespace cps {

/// The format of this name, or every one for `all`. Throws std::runtime_error that lists the names.
std::vector<CalibrationFormat> formats_of_word(const std::string& word);

/// Writes the camera in each of the formats, as <folder>/<prefix><the format's usual file name>. Of several
/// formats, those that cannot say the lens are left out, with a line on the screen. Throws as
/// write_model_calibration() does.
void write_camera_files(const std::filesystem::path& folder, const std::string& prefix,
                        std::span<const CalibrationFormat> formats, const ModelCamera& camera);

}  // namespace cps
