#pragma once

#include <filesystem>
#include <vector>

#include "distortion/calibrated_camera.h"

namespace cps {

/// A known camera and pictures that it took.
struct CameraPictures {
  CalibratedCamera camera;
  std::vector<std::filesystem::path> files;
};

/// KITTI raw data, not rectified: the frames of image_00 … image_03 of every drive below a folder (a date, or
/// one of several), with the calibration in calib_cam_to_cam.txt of the date; an entry per date and camera
/// that has frames. Throws std::runtime_error in one line when there is no such file or there are no frames.
std::vector<CameraPictures> kitti_raw(const std::filesystem::path& folder);

/// The pictures in a folder (not below it), in the order of their names. Throws std::runtime_error when it
/// is no folder or there are none.
std::vector<std::filesystem::path> pictures_in(const std::filesystem::path& folder);

}  // namespace cps
