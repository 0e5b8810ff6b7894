#include "trainer/calibration/targets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "trainer/calibration/seen_hfov.h"

namespace cps {
namespace {

/// The factors that turn raw outputs into apparent ones.
Outputs apparent_scale(double fov, int width, int height) {
  const double half_diagonal = std::tan(fov / 2) * std::hypot(1.0, static_cast<double>(height) / width);
  const double r2 = half_diagonal * half_diagonal;
  return {1, r2, r2 * r2, r2 * r2 * r2, half_diagonal, half_diagonal, 1, 1};
}

Outputs to_apparent(Outputs outputs, TargetSpace from, int width, int height) {
  if (from == TargetSpace::seen) outputs[0] = label_from_seen_fov(outputs, width, height);
  if (from != TargetSpace::raw) return outputs;
  const Outputs scale = apparent_scale(outputs[0], width, height);
  for (int i = 0; i < output_count; ++i) outputs[i] *= scale[i];
  return outputs;
}

Outputs from_apparent(Outputs outputs, TargetSpace to, int width, int height) {
  if (to == TargetSpace::seen) outputs[0] = seen_from_label_fov(outputs, width, height);
  if (to != TargetSpace::raw) return outputs;
  const Outputs scale = apparent_scale(outputs[0], width, height);
  for (int i = 0; i < output_count; ++i) outputs[i] /= scale[i];
  return outputs;
}

}  // namespace

std::string to_string(TargetSpace space) {
  return space == TargetSpace::raw ? "raw" : space == TargetSpace::apparent ? "apparent" : "seen";
}

TargetSpace target_space_from_string(const std::string& word) {
  for (TargetSpace space : {TargetSpace::raw, TargetSpace::apparent, TargetSpace::seen})
    if (word == to_string(space)) return space;
  throw std::runtime_error("target space '" + word + "': unknown: use raw, apparent or seen");
}

Outputs to_outputs(const CalibratedCamera& camera, TargetSpace space) {
  const Pinhole& pinhole = camera.pinhole;
  const Distortion& d = camera.distortion;
  const Outputs raw{hfov_rad(pinhole),          d.k1, d.k2, d.k3, d.p1, d.p2, pinhole.cx / pinhole.width,
                    pinhole.cy / pinhole.height};
  return convert(raw, TargetSpace::raw, space, pinhole.width, pinhole.height);
}

std::optional<CalibratedCamera> to_camera(const Outputs& outputs, TargetSpace space, int width, int height) {
  if (!(outputs[0] > 0 && outputs[0] < std::numbers::pi)) return std::nullopt;
  const Outputs raw = convert(outputs, space, TargetSpace::raw, width, height);
  if (!std::ranges::all_of(raw, [](double v) { return std::isfinite(v); })) return std::nullopt;
  CalibratedCamera camera{
      "", pinhole_from_hfov(width, height, raw[0]), {raw[1], raw[2], raw[3], raw[4], raw[5]}};
  camera.pinhole.cx = raw[6] * width;
  camera.pinhole.cy = raw[7] * height;
  return camera;
}

Outputs convert(const Outputs& outputs, TargetSpace from, TargetSpace to, int width, int height) {
  if (from == to) return outputs;
  return from_apparent(to_apparent(outputs, from, width, height), to, width, height);
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
