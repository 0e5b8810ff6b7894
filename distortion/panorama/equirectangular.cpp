#include "distortion/panorama/equirectangular.h"

#include <cmath>
#include <numbers>

#include "distortion/models/straight_angle.h"

namespace cps {

using std::numbers::pi;

Eigen::Vector3d direction(const Panorama& panorama, const Eigen::Vector2d& pixel) {
  const SineCosine longitude = straight_sine_cosine(longitude_rad(panorama, pixel.x()));
  const SineCosine latitude = straight_sine_cosine(latitude_rad(panorama, pixel.y()));
  return {latitude.cosine * longitude.sine, -latitude.sine, latitude.cosine * longitude.cosine};
}

Eigen::Vector2d pixel(const Panorama& panorama, const Eigen::Vector3d& direction) {
  const double longitude = std::atan2(direction.x(), direction.z());
  const double latitude = std::atan2(-direction.y(), std::hypot(direction.x(), direction.z()));
  const double x = (longitude / (2 * pi) + 0.5) * panorama.width - 0.5;
  return {x < panorama.width - 0.5 ? x : -0.5, (0.5 - latitude / pi) * panorama.height - 0.5};
}

double longitude_rad(const Panorama& panorama, double column) {
  return 2 * pi * ((column + 0.5) / panorama.width - 0.5);
}

double latitude_rad(const Panorama& panorama, double row) {
  return pi * (0.5 - (row + 0.5) / panorama.height);
}

}  // namespace cps
