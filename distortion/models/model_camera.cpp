#include "distortion/models/model_camera.h"

#include "distortion/label_algebra.h"

namespace cps {

ModelCamera resized(const ModelCamera& camera, int width, int height) {
  const CalibratedCamera pinhole_only{.name = {}, .pinhole = camera.pinhole, .distortion = {}};
  return {camera.name, resized(pinhole_only, width, height).pinhole, camera.lens};
}

}  // namespace cps
