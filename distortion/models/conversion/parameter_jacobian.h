#pragma once

#include <Eigen/Core>

#include "distortion/models/lens_model.h"

namespace cps {

/// How the normalised image point of a ray moves with a lens' parameters: a column for each, in the order of
/// parameters().
using ParameterJacobian = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, 8>;

/// ∂project(lens, ray)/∂parameters in closed form. The ray (camera frame) has any positive length. Unchecked:
/// its angle from the axis is below angle_limit().
ParameterJacobian parameter_jacobian(const LensModel& lens, const Eigen::Vector3d& ray);

}  // namespace cps
