#pragma once

#include <cstdint>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/model_camera.h"

namespace cps {

/// How exactly a camera's pixels are inverted, at their centres.
struct ModelSurvey {
  std::int64_t pixels = 0;       ///< examined: all, or a regular grid of about a million of a larger image
  std::int64_t outside = 0;      ///< of those, proved to lie outside what the region shows
  double worst_residual_px = 0;  ///< of unproject(), |project(ray) − pixel|
};

/// The region must be proved for the camera's lens (not checked). Gives the same result for any number of
/// threads.
ModelSurvey survey_inversion(const ModelCamera& camera, const RayRegion& region);

}  // namespace cps
