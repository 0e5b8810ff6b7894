#include "dataset/exchange/plausible_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace cps {
namespace {

void check_pinhole(const Pinhole& pinhole, const std::string& where) {
  constexpr int max_side_px = 100'000;
  constexpr double max_focal_in_widths = 1000;
  const auto& [width, height, fx, fy, cx, cy] = pinhole;
  if (width < 1 || height < 1 || width > max_side_px || height > max_side_px)
    throw std::runtime_error(where + ": width, height: must lie between 1 and 100000 pixels");
  if (!(fx > 0 && fy > 0 && std::isfinite(fx) && std::isfinite(fy)))
    throw std::runtime_error(where + ": fx, fy: must be positive and finite");
  const double longest = std::max(width, height);
  if (std::max(fx, fy) > max_focal_in_widths * longest || std::min(fx, fy) < longest / max_focal_in_widths)
    throw std::runtime_error(where + ": fx, fy: beyond any lens: must be focal lengths in pixels");
  if (!(cx > -0.5 && cx < width - 0.5 && cy > -0.5 && cy < height - 0.5))
    throw std::runtime_error(where + ": cx, cy: the principal point lies outside the image");
}

/// The corner's radius to the power by which the family's formula multiplies the parameter; 0 for parameters
/// that are no coefficients of a polynomial.
int power_of_radius(std::string_view parameter, const LensModel& lens) {
  if (parameter.size() != 2) return 0;
  if (parameter[0] == 'p') return 1;
  if (parameter[0] != 'k') return 0;
  const int number = parameter[1] - '0';
  const bool is_denominator = std::holds_alternative<RationalLens>(lens) && number > 3;
  return 2 * (is_denominator ? number - 3 : number);
}

}  // namespace

void check_plausible(const ModelCamera& camera, const std::string& where) {
  constexpr double max_product = 100, max_shape = 1000;  // far outside what exists
  const Pinhole& pinhole = camera.pinhole;
  check_pinhole(pinhole, where);
  for (const auto& [name, value] : parameters(camera.lens))
    if (!std::isfinite(value))
      throw std::runtime_error(where + ": " + std::string(name) + ": must be finite");
  double r = std::hypot(0.5 * pinhole.width / pinhole.fx, 0.5 * pinhole.height / pinhole.fy);
  if (std::holds_alternative<KannalaBrandt>(camera.lens)) r = std::min(r, std::numbers::pi);  // an angle
  for (const auto& [name, value] : parameters(camera.lens)) {
    const int power = power_of_radius(name, camera.lens);
    if (std::abs(value) * std::pow(r, power) > (power == 0 ? max_shape : max_product))
      throw std::runtime_error(where + ": " + std::string(name) +
                               ": beyond any lens: check its unit and its order in the file");
  }
  if (const std::string why = fault(camera.lens); !why.empty()) throw std::runtime_error(where + ": " + why);
}

}  // namespace cps
