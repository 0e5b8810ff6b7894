#include "trainer/calibration/certified_lens.h"

#include <algorithm>

#include "distortion/certificate/frame_certificate.h"

namespace cps {
namespace {

Distortion scaled(const Distortion& d, double share) {
  return {share * d.k1, share * d.k2, share * d.k3, share * d.p1, share * d.p2};
}

}  // namespace

CertifiedLens pull_to_certified(const Calibration& predicted) {
  CertifiedLens result{predicted};
  Pinhole& camera = result.calibration.camera;
  camera.cx = std::clamp(camera.cx, 0.0, camera.width - 1.0);
  camera.cy = std::clamp(camera.cy, 0.0, camera.height - 1.0);
  const auto is_certified_at = [&](double share) {
    return certify_frame(scaled(predicted.distortion, share), camera).valid();
  };
  if (is_certified_at(1)) return result;
  double low = 0, high = 1;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (is_certified_at(middle) ? low : high) = middle;
  }
  result.kept = low;
  result.calibration.distortion = scaled(predicted.distortion, low);
  return result;
}

}  // namespace cps
