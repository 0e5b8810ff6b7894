#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "distortion/image_size.h"
#include "trainer/calibration/targets.h"

/// A camera's eight numbers as people read them: H-FOV in degrees, coefficients, principal point in pixels.
namespace cps {

/// One of them.
struct CameraNumber {
  const char *name, *unit;
  double (*value)(const CalibratedCamera&);
  double (*unit_of_raw)(const CalibratedCamera&);  ///< a raw output of 1 in this unit
};

/// In the order of the outputs.
std::span<const CameraNumber, output_count> camera_numbers();

/// An object with the keys output_names.
nlohmann::ordered_json numbers_json(const CalibratedCamera& camera);

/// The same of deviations or differences in raw units, for an image of this size.
nlohmann::ordered_json numbers_json(const Outputs& raw, const ImageSize& size);

}  // namespace cps
