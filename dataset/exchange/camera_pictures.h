#pragma once

#include <filesystem>
#include <vector>

#include "distortion/calibrated_camera.h"

namespace cps {

/// A calibrated camera and pictures that it took.
struct CameraPictures {
  CalibratedCamera camera;
  std::vector<std::filesystem::path> files;
};

/// KITTI raw data, unrectified: the frames of image_00 … image_03 of every drive, with the calibration in the
/// date's calib_cam_to_cam.txt. `folder` is a date's folder or one that holds several. One entry for each
/// date and camera that has frames. Throws std::runtime_error with one line when there is no calibration or
/// no frame.
std::vector<CameraPictures> kitti_raw(const std::filesystem::path& folder);

/// The pictures in a folder (not below it), sorted by name. A leaf folder of a dataset holds labels of
/// pixels, too, such as 000017.instance.png and valid.png: they are left out. Throws std::runtime_error when
/// it is no folder or holds no picture.
std::vector<std::filesystem::path> pictures_in(const std::filesystem::path& folder);

}  // namespace cps
