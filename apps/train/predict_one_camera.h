#pragma once

#include <filesystem>
#include <vector>

#include "dataset/exchange/calibration_file.h"
#include "trainer/fit/one_camera.h"
#include "trainer/model/predictor.h"

namespace cps {

/// What `cps predict --one-camera` is asked for.
struct OneCameraRequest {
  std::vector<std::filesystem::path> pictures;
  std::filesystem::path cameras;  ///< folder for the calibration; empty: none is written
  std::filesystem::path json;     ///< empty: one_camera.json in `cameras`, if there is such a folder
  std::vector<CalibrationFormat> formats;
  OneCameraOptions options;
};

/// Prints the camera that took the pictures and writes its files. Throws boost::program_options::error if the
/// model's head has no fit, and std::runtime_error with one line as predict_one_camera() and the writers do.
void predict_all_as_one_camera(const Predictor& predictor, const OneCameraRequest& request);

}  // namespace cps
