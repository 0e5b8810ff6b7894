#pragma once

#include <Eigen/Core>

#include "distortion/panorama/equirectangular.h"
#include "distortion/warp/pixel_kernel.h"

namespace cps {

/// The largest angle between a kernel's centre and its edge. Pixels that see more are not averages of
/// anything local, and are treated as uncovered.
inline constexpr double widest_reach_rad = 0.5;

/// A kernel on the sphere, about a direction. It lives in the plane that touches the sphere there, in
/// coordinates x to the east and y down, the components of unit directions in pixels of the panorama's
/// equator.
struct SphericalFootprint {
  double sine_latitude, cosine_latitude, sine_longitude, cosine_longitude;  ///< of the direction
  PixelKernel kernel;
  double reach_rad;  ///< angle of the farthest point of the kernel's ellipse, at most π/2
};

/// The footprint of an output pixel with this ray (unit length) and ∂ray/∂(column, row), both in the
/// panorama's frame. A panorama's pixel at the latitude φ is cos φ wide and 1 high, so the kernel's
/// covariance is sigma² A Aᵀ − diag(cos² φ, 1)/12 with A = ∂(x, y)/∂output px, floored as pixel_kernel()
/// does.
SphericalFootprint spherical_footprint(const Panorama& panorama, const Eigen::Vector3d& ray,
                                       const Eigen::Matrix<double, 3, 2>& jacobian, double sigma_px);

}  // namespace cps
