#pragma once

#include <Eigen/Core>
#include <array>

#include "trainer/calibration/targets.h"

/// The unknowns of a fit of a camera to the edges of a picture: the eight outputs in TargetSpace::seen, then
/// three angles of the camera in the street, in radians.
///
/// pitch: the optical axis above the horizon. roll: the camera turned clockwise about its axis, as seen from
/// behind; a positive one makes upright things lean to the left. yaw: the street's cross direction turned
/// from the camera's own, positive where its right end is farther away.
namespace cps {

inline constexpr int fit_parameter_count = output_count + 3;
inline constexpr int pitch_parameter = output_count, roll_parameter = output_count + 1,
                     yaw_parameter = output_count + 2;

using FitVector = Eigen::Matrix<double, fit_parameter_count, 1>;
using FitMatrix = Eigen::Matrix<double, fit_parameter_count, fit_parameter_count>;

/// What is known of the three angles without the picture: standard deviations about zero, in radians, for a
/// camera on a car in a street that it follows.
inline constexpr std::array<double, 3> angle_deviation{.09, .05, .2};

}  // namespace cps
