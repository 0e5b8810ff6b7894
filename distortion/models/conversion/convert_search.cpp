#include "distortion/models/conversion/convert_search.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "distortion/models/projection.h"

namespace cps {
namespace {

bool is_tangential(std::string_view parameter) {
  return parameter == "p1" || parameter == "p2";
}

bool has_tangential_terms(const LensModel& lens) {
  const auto known = parameters(lens);
  return std::any_of(known.begin(), known.end(), [](const auto& parameter) {
    return is_tangential(parameter.first) && parameter.second != 0;
  });
}

/// The lens without its tangential terms.
RadialProfile profile_of(const LensModel& lens, double max_angle_rad) {
  HeldParameters values;
  for (const auto& [name, value] : parameters(lens))
    if (!is_tangential(name)) values[std::string(name)] = value;
  const LensModel radial = lens_from_parameters(family_name(lens), values);
  constexpr int samples = 64;
  RadialProfile profile{.angle_rad = Eigen::ArrayXd(samples), .radius = Eigen::ArrayXd(samples)};
  for (int i = 0; i < samples; ++i) {
    const double angle = max_angle_rad * (i + 1) / samples;
    profile.angle_rad[i] = angle;
    profile.radius[i] = project(radial, {std::sin(angle), 0, std::cos(angle)}).point.x();
  }
  return profile;
}

struct Candidate {
  double error_px2 = std::numeric_limits<double>::infinity();
  ModelCamera camera = {};
};

/// Fits of one family to the rays of one camera.
struct Fits {
  const ModelCamera& camera;
  std::string_view family;
  const SeenRays& seen;
  RadialProfile profile;
  bool pinhole_is_free;

  /// All variables free except what is held.
  Candidate from(const ModelCamera& start, const HeldParameters& held) const {
    FreeVariables free{.pinhole = pinhole_is_free};
    const auto known = parameters(start.lens);
    for (std::size_t i = 0; i < known.size(); ++i)
      if (!held.contains(std::string(known[i].first))) free.parameters.push_back(static_cast<int>(i));
    Candidate result{.error_px2 = squared_error_px2(start, seen), .camera = start};
    if (!std::isfinite(result.error_px2)) return {};
    result.camera = fitted(start, seen, free);
    result.error_px2 = squared_error_px2(result.camera, seen);
    return result;
  }

  /// From the closed-form start; the shape parameter, if there is one, is held.
  Candidate with(const HeldParameters& held) const {
    const auto start = fit_start(family, profile, held);
    if (!start) return {};
    ModelCamera scaled{.name = camera.name, .pinhole = camera.pinhole, .lens = start->lens};
    scaled.pinhole.fx *= start->scale;
    scaled.pinhole.fy *= start->scale;
    return from(scaled, held);
  }
};

Candidate best_over_shapes(const Fits& fits, const ShapeParameter& shape, const HeldParameters& held) {
  const auto at = [&](double value) {
    HeldParameters with_shape = held;
    with_shape[shape.name] = value;
    return fits.with(with_shape);
  };
  std::vector<double> errors;
  for (const double value : shape.values) errors.push_back(at(value).error_px2);
  Candidate best;
  const std::size_t last = errors.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, last);
    if (!std::isfinite(errors[i]) || errors[i] > errors[before] || errors[i] > errors[after]) continue;
    constexpr double beyond_all_errors = 1e100;  // finite, so that Brent's parabolas stay numbers
    constexpr int bits = 26;                     // half of a double's: a minimum is no better defined
    const auto [value, error] = boost::math::tools::brent_find_minima(
        [&](double tried) { return std::min(at(tried).error_px2, beyond_all_errors); }, shape.values[before],
        shape.values[after], bits);
    const Candidate found = fits.from(at(error < errors[i] ? value : shape.values[i]).camera, held);
    if (found.error_px2 < best.error_px2) best = found;
  }
  return best;
}

}  // namespace

std::optional<ModelCamera> best_fit(const ModelCamera& camera, std::string_view family, const SeenRays& seen,
                                    const HeldParameters& held) {
  const bool has_tangential = has_tangential_terms(camera.lens);
  HeldParameters fixed = held;
  for (const auto& [name, value] : parameters(lens_from_parameters(family, {})))
    if (is_tangential(name) && !has_tangential) fixed.try_emplace(std::string(name), 0);
  const Fits fits{.camera = camera,
                  .family = family,
                  .seen = seen,
                  .profile = profile_of(camera.lens, seen.max_angle_rad),
                  .pinhole_is_free = has_tangential};
  const auto shape = shape_parameter(family);
  const Candidate best =
      shape && !fixed.contains(shape->name) ? best_over_shapes(fits, *shape, fixed) : fits.with(fixed);
  if (!std::isfinite(best.error_px2)) return {};
  return best.camera;
}

}  // namespace cps
