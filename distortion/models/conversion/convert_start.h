#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "distortion/models/lens_model.h"

/// Where the fits of convert.h begin.
namespace cps {

/// Values of a family's parameters, by name.
using HeldParameters = std::map<std::string, double>;

/// A radially symmetric lens as samples: at the angle from the axis, the radius in the normalised image.
struct RadialProfile {
  Eigen::ArrayXd angle_rad, radius;
};

/// The parameter that bends a family's profile most, by which its other parameters follow closely: ξ of
/// unified_spherical and double_sphere, β of eucm.
struct ShapeParameter {
  std::string name;
  std::vector<double> values;  ///< ascending, from end to end of what lenses have
};

/// Empty for families that are polynomials.
std::optional<ShapeParameter> shape_parameter(std::string_view family);

/// A lens that resembles a profile after both focal lengths were multiplied by `scale`.
struct FitStart {
  double scale = 1;
  LensModel lens;
};

/// The lens of a family with the `held` parameters, the shape parameter among them: coefficients k1, k2, … by
/// linear least squares, α from a list, tangential terms 0. Empty if it does not reach the profile's angles.
/// Throws std::runtime_error if the family does not know what is held.
std::optional<FitStart> fit_start(std::string_view family, const RadialProfile& profile,
                                  const HeldParameters& held);

}  // namespace cps
