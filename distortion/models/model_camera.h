#pragma once

#include <string>

#include "distortion/calibrated_camera.h"
#include "distortion/models/lens_model.h"

namespace cps {

/// A calibrated camera of any lens family. The pinhole's focal lengths and principal point map the normalised
/// image to pixels: u = fx x + cx, v = fy y + cy.
struct ModelCamera {
  std::string name;
  Pinhole pinhole;
  LensModel lens;
  bool operator==(const ModelCamera&) const = default;
};

/// A Brown–Conrady camera as one of any family.
inline ModelCamera model_camera(const CalibratedCamera& camera) {
  return {camera.name, camera.pinhole, camera.distortion};
}

/// The camera after its pictures were resized to width × height pixels: focal lengths and principal point are
/// scaled, the lens stays.
ModelCamera resized(const ModelCamera& camera, int width, int height);

}  // namespace cps
