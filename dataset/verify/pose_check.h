#pragma once

#include "dataset/verify/dataset_files.h"

namespace cps {

/// Checks every camera pose in frames.csv against the vehicle's pose beside it and T_vehicle_camera in
/// calibration.json: they agree within eight standard deviations of the mount errors that the recipe draws.
/// Gravity must follow from the camera's pose.
void check_poses(const DatasetFiles& files, Faults& faults);

}  // namespace cps
