#include "trainer/deepcalib/sphere_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "distortion/models/certificate/sphere_reach.h"

namespace cps {
namespace {

double share_of(double value, const Interval& interval) {
  return (value - interval.low) / (interval.high - interval.low);
}

double value_at(double share, const Interval& interval) {
  return interval.low + share * (interval.high - interval.low);
}

/// ξ; empty if the lens has anything beside it.
std::optional<double> sole_xi(const LensModel& lens) {
  if (const auto* sphere = std::get_if<UnifiedSpherical>(&lens); sphere && sphere->distortion == Distortion{})
    return sphere->xi;
  if (const auto* plane = std::get_if<Distortion>(&lens); plane && *plane == Distortion{}) return 0.0;
  return std::nullopt;
}

/// Empty, or one line why two numbers cannot describe the pinhole part.
std::string pinhole_fault(const Pinhole& camera) {
  constexpr double agreement = 1e-6;  // relative
  if (!(std::abs(camera.fy / camera.fx - 1) <= agreement)) return "K: its pixels are not square";
  if (!(std::abs(camera.cx - .5 * (camera.width - 1)) <= agreement * camera.width &&
        std::abs(camera.cy - .5 * (camera.height - 1)) <= agreement * camera.height))
    return "K: its principal point is not the image's middle";
  return "";
}

/// Rounding of labels must not push a number out of its interval.
bool is_share(double share) {
  constexpr double rounding = 1e-9;
  return share >= -rounding && share <= 1 + rounding;
}

}  // namespace

SphereTarget to_sphere_target(const ModelCamera& camera, const std::string& label) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(label + ": " + why +
                             ": a DeepCalib network learns a focal length and xi alone; make a dataset with "
                             "lens_model = unified_spherical, as recipe deepcalib does");
  };
  const std::optional<double> xi = sole_xi(camera.lens);
  if (!xi) refuse("model: its lens is " + description(camera.lens));
  if (const std::string fault = pinhole_fault(camera.pinhole); !fault.empty()) refuse(fault);
  const double focal_px = camera.pinhole.fx * deepcalib_width_px / camera.pinhole.width;
  const SphereTarget target{share_of(focal_px, deepcalib_focal_px), share_of(*xi, deepcalib_xi)};
  if (!is_share(target.focal))
    refuse(fmt::format("K: its focal length at {:g} pixels of width, {:.4g}, lies outside {:g} ... {:g}",
                       deepcalib_width_px, focal_px, deepcalib_focal_px.low, deepcalib_focal_px.high));
  if (!is_share(target.xi))
    refuse(fmt::format("params: xi, {:.4g}, lies outside {:g} ... {:g}", *xi, deepcalib_xi.low,
                       deepcalib_xi.high));
  return {std::clamp(target.focal, 0., 1.), std::clamp(target.xi, 0., 1.)};
}

ModelCamera to_model_camera(const SphereTarget& target, int width, int height) {
  const double focal = value_at(target.focal, deepcalib_focal_px) * width / deepcalib_width_px;
  return {.name = {},
          .pinhole = {width, height, focal, focal, .5 * (width - 1), .5 * (height - 1)},
          .lens = UnifiedSpherical{.xi = value_at(target.xi, deepcalib_xi)}};
}

double seen_hfov_rad(const SphereTarget& target, int width) {
  const ModelCamera camera = to_model_camera(target, width, width);
  const double xi = value_at(target.xi, deepcalib_xi), end = .5 * width / camera.pinhole.fx;
  return 2 * angle_on_sphere(xi, std::min(end, sphere_reach(xi).max_radius));
}

SphereStatistics sphere_statistics(std::span<const SphereTarget> targets) {
  SphereStatistics fit;
  const double n = static_cast<double>(targets.size());
  for (const auto member : {&SphereTarget::focal, &SphereTarget::xi}) {
    double sum = 0, squares = 0;
    for (const SphereTarget& target : targets) sum += target.*member;
    const double mean = sum / n;
    for (const SphereTarget& target : targets) squares += (target.*member - mean) * (target.*member - mean);
    const double deviation = std::sqrt(squares / n);
    fit.mean.*member = mean;
    fit.deviation.*member = deviation > 1e-12 ? deviation : 1;
  }
  return fit;
}

}  // namespace cps
