#include "distortion/models/warp/proved_camera.h"

#include <stdexcept>

#include "distortion/warp/warp_options.h"

namespace cps {

bool is_empty(const RayRegion& region) {
  if (!(region.max_angle_rad > 0)) return true;
  return region.box && !(region.box->sizes().minCoeff() > 0);
}

ProvedCamera proved_camera(const ModelCamera& camera) {
  const ModelCertificate proof = certify_frame(camera, warpable);
  if (is_empty(proof.region)) throw std::runtime_error("warp: " + proof.why);
  return {camera, proof.region};
}

}  // namespace cps
