#pragma once

#include <filesystem>
#include <optional>

#include "distortion/calibrated_camera.h"
#include "distortion/image_size.h"

namespace cps {

/// The camera in the calibration.json beside an image of this size, with the rig camera's name, if there is
/// one. Throws std::runtime_error with one line if it is invalid, of another lens family or of another size.
std::optional<CalibratedCamera> truth_beside(const std::filesystem::path& image, const ImageSize& size);

}  // namespace cps
