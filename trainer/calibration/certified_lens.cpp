#include "trainer/calibration/certified_lens.h"

#include <algorithm>

#include "distortion/certificate/frame_certificate.h"

namespace cps {
namespace {

Distortion scaled(const Distortion& d, double factor) {
  return {factor * d.k1, factor * d.k2, factor * d.k3, factor * d.p1, factor * d.p2};
}

}  // namespace

CertifiedLens pull_to_certified(const CalibratedCamera& predicted) {
  CertifiedLens result{predicted};
  Pinhole& pinhole = result.camera.pinhole;
  pinhole.cx = std::clamp(pinhole.cx, 0.0, pinhole.width - 1.0);
  pinhole.cy = std::clamp(pinhole.cy, 0.0, pinhole.height - 1.0);
  const auto is_certified_at = [&](double factor) {
    return certify_frame(scaled(predicted.distortion, factor), pinhole).valid();
  };
  if (is_certified_at(1)) return result;
  double low = 0, high = 1;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (is_certified_at(middle) ? low : high) = middle;
  }
  result.kept = low;
  result.camera.distortion = scaled(predicted.distortion, low);
  return result;
}

}  // namespace cps
