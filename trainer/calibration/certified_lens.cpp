#include "trainer/calibration/certified_lens.h"

#include <algorithm>
#include <optional>

#include "distortion/certificate/frame_certificate.h"
#include "trainer/calibration/reprojection.h"

namespace cps {
namespace {

Distortion scaled(const Distortion& d, double factor) {
  return {factor * d.k1, factor * d.k2, factor * d.k3, factor * d.p1, factor * d.p2};
}

/// The largest factor in [0, 1] for which `holds`, by bisection to 1e-6; it must hold for 0.
template <typename Holds>
double largest_factor(Holds holds) {
  if (holds(1)) return 1;
  double low = 0, high = 1;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

CertifiedLens pull_to_certified(const CalibratedCamera& predicted) {
  CertifiedLens result{predicted};
  Pinhole& pinhole = result.camera.pinhole;
  pinhole.cx = std::clamp(pinhole.cx, 0.0, pinhole.width - 1.0);
  pinhole.cy = std::clamp(pinhole.cy, 0.0, pinhole.height - 1.0);
  result.kept = largest_factor(
      [&](double factor) { return certify_frame(scaled(predicted.distortion, factor), pinhole).valid(); });
  if (result.kept < 1) result.camera.distortion = scaled(predicted.distortion, result.kept);
  return result;
}

Outputs pulled_to_one_to_one(const Outputs& outputs, TargetSpace space, const ImageSize& size) {
  if (!to_camera(outputs, space, size.width, size.height)) return outputs;
  Outputs inside = outputs;
  inside[6] = std::clamp(outputs[6], 0.0, 1 - 1.0 / size.width);
  inside[7] = std::clamp(outputs[7], 0.0, 1 - 1.0 / size.height);
  const auto with = [&](double factor) {
    Outputs result = inside;
    for (int i = 1; i <= 5; ++i) result[i] *= factor;
    return result;
  };
  return with(largest_factor([&](double factor) {
    const std::optional<CalibratedCamera> camera = to_camera(with(factor), space, size.width, size.height);
    return camera && is_one_to_one(*camera);
  }));
}

}  // namespace cps
