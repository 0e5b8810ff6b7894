#pragma once

#include <Eigen/Core>
#include <optional>

#include "distortion/models/certificate/model_certificate.h"

namespace cps {

/// The unit ray in `region` (camera frame) that the lens sends to `point` of the normalised image; empty if
/// that point provably lies outside the region's image. The region must be proved for this lens (not
/// checked). eucm, double_sphere and the sphere of unified_spherical have closed forms; kannala_brandt is
/// solved by Newton steps kept in a bracket; the families of the plane by undistort()'s convex minimisation.
/// The residual |project(ray) − point| is at rounding level.
std::optional<Eigen::Vector3d> unproject(const LensModel& lens, const RayRegion& region,
                                         const Eigen::Vector2d& point);

/// A ray with its derivative ∂ray/∂point; the derivative is orthogonal to the ray.
struct UnprojectedPoint {
  Eigen::Vector3d ray;  ///< unit length
  Eigen::Matrix<double, 3, 2> jacobian;
};
std::optional<UnprojectedPoint> unproject_with_jacobian(const LensModel& lens, const RayRegion& region,
                                                        const Eigen::Vector2d& point);

}  // namespace cps
