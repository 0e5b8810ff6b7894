#include "trainer/calibration/targets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cps {
namespace {

/// What each output is multiplied by on its way from raw to apparent.
Outputs apparent_scale(double fov, int width, int height) {
  const double half_diagonal = std::tan(fov / 2) * std::hypot(1.0, static_cast<double>(height) / width);
  const double r2 = half_diagonal * half_diagonal;
  return {1, r2, r2 * r2, r2 * r2 * r2, half_diagonal, half_diagonal, 1, 1};
}

}  // namespace

std::string to_string(TargetSpace space) {
  return space == TargetSpace::raw ? "raw" : "apparent";
}

TargetSpace target_space_from_string(const std::string& word) {
  if (word == "raw") return TargetSpace::raw;
  if (word == "apparent") return TargetSpace::apparent;
  throw std::runtime_error("target space '" + word + "': not known: say raw or apparent");
}

Outputs to_outputs(const Calibration& calibration, TargetSpace space) {
  const Pinhole& camera = calibration.camera;
  const Distortion& d = calibration.distortion;
  const Outputs raw{hfov_rad(camera),         d.k1, d.k2, d.k3, d.p1, d.p2, camera.cx / camera.width,
                    camera.cy / camera.height};
  return convert(raw, TargetSpace::raw, space, camera.width, camera.height);
}

std::optional<Calibration> to_calibration(const Outputs& outputs, TargetSpace space, int width, int height) {
  if (!(outputs[0] > 0 && outputs[0] < std::numbers::pi)) return std::nullopt;
  const Outputs raw = convert(outputs, space, TargetSpace::raw, width, height);
  if (!std::ranges::all_of(raw, [](double v) { return std::isfinite(v); })) return std::nullopt;
  Calibration calibration{pinhole_from_hfov(width, height, raw[0]), {raw[1], raw[2], raw[3], raw[4], raw[5]}};
  calibration.camera.cx = raw[6] * width;
  calibration.camera.cy = raw[7] * height;
  return calibration;
}

Outputs convert(const Outputs& outputs, TargetSpace from, TargetSpace to, int width, int height) {
  if (from == to) return outputs;
  const Outputs scale = apparent_scale(outputs[0], width, height);
  Outputs converted = outputs;
  for (int i = 0; i < output_count; ++i)
    converted[i] = to == TargetSpace::apparent ? outputs[i] * scale[i] : outputs[i] / scale[i];
  return converted;
}

Standardisation fit_standardisation(std::span<const Outputs> targets) {
  Standardisation fit;
  const double n = static_cast<double>(targets.size());
  for (int i = 0; i < output_count; ++i) {
    double sum = 0, squares = 0;
    for (const Outputs& t : targets) sum += t[i];
    fit.mean[i] = sum / n;
    for (const Outputs& t : targets) squares += (t[i] - fit.mean[i]) * (t[i] - fit.mean[i]);
    const double deviation = std::sqrt(squares / n);
    fit.deviation[i] = deviation > 1e-12 * (1 + std::abs(fit.mean[i])) ? deviation : 1;
  }
  return fit;
}

Outputs standardise(const Outputs& outputs, const Standardisation& by) {
  Outputs result;
  for (int i = 0; i < output_count; ++i) result[i] = (outputs[i] - by.mean[i]) / by.deviation[i];
  return result;
}

Outputs unstandardise(const Outputs& outputs, const Standardisation& by) {
  Outputs result;
  for (int i = 0; i < output_count; ++i) result[i] = by.mean[i] + by.deviation[i] * outputs[i];
  return result;
}

}  // namespace cps
