#include "distortion/panorama/spherical_footprint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps {

SphericalFootprint spherical_footprint(const Panorama& panorama, const Eigen::Vector3d& ray,
                                       const Eigen::Matrix<double, 3, 2>& jacobian, double sigma_px) {
  SphericalFootprint result;
  // At a pole every direction is as good as another for x.
  const double across = std::sqrt(ray.x() * ray.x() + ray.z() * ray.z());
  const double sine_latitude = -ray.y();
  const double sine = across > 0 ? ray.x() / across : 0, cosine = across > 0 ? ray.z() / across : 1;
  result.sine_latitude = sine_latitude;
  result.cosine_latitude = across;
  result.sine_longitude = sine;
  result.cosine_longitude = cosine;

  const double per_rad = panorama.width / (2 * std::numbers::pi);
  const Eigen::RowVector3d east(cosine, 0, -sine);
  const Eigen::RowVector3d down(sine_latitude * sine, across, sine_latitude * cosine);
  const Eigen::RowVector2d x = per_rad * (east * jacobian), y = per_rad * (down * jacobian);
  result.kernel = pixel_kernel({x[0], x[1], y[0], y[1]}, sigma_px * sigma_px,
                               pixel_variance * across * across, pixel_variance);

  // The squares of the bounding box's half sides add up to those of the ellipse's half axes.
  const PixelKernel& kernel = result.kernel;
  const double shorter2 = kernel_support * kernel_support *
                          std::max(kernel.smaller_variance, narrowest_sigma_px * narrowest_sigma_px);
  const double longer =
      std::sqrt(kernel.half_width * kernel.half_width + kernel.half_height * kernel.half_height - shorter2);
  result.reach_rad = std::asin(std::min(1.0, longer / per_rad));
  return result;
}

}  // namespace cps
