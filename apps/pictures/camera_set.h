#pragma once

#include <filesystem>
#include <string>

#include "dataset/relens_draw.h"

namespace cps {

/// Pictures of calibrated cameras.
struct CameraSource {
  std::string kitti;  ///< folder of KITTI raw data, or empty
  std::string pictures, lens,
      lens_camera;               ///< folder of pictures of one camera and its calibration, or empty
  double straight_hfov_deg = 0;  ///< of the straightened pictures; 0: as wide as they allow
};

/// Makes the dataset `root`: each picture is straightened and warped through drawn lenses; all images are
/// `test`. Throws std::runtime_error in one line: no pictures, a calibration that cannot be read or used, no
/// lens that the pictures suffice for.
void make_camera_set(const CameraSource& source, const std::filesystem::path& root,
                     const RelensOptions& options);

}  // namespace cps
