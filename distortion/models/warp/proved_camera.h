#pragma once

#include "distortion/models/certificate/model_certificate.h"

namespace cps {

/// A camera, and the rays on which its lens is proved one-to-one.
struct ProvedCamera {
  ModelCamera camera;
  RayRegion region;
};

/// Whether the region holds no ray beside the axis.
bool is_empty(const RayRegion& region);

/// The camera on its frame or, where there is no proof for the whole frame, on the largest region that is
/// proved. Throws std::runtime_error in one line if nothing is.
ProvedCamera proved_camera(const ModelCamera& camera);

}  // namespace cps
