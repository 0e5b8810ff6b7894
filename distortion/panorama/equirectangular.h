#pragma once

#include <Eigen/Core>

namespace cps {

/// Pixels and directions of an equirectangular panorama of width × height pixels (height = width / 2). The
/// panorama's frame is a camera's (x right, y down, z forward); its middle looks along z, its left half
/// towards −x, its top up (−y). The centre of the top-left pixel is (0, 0).
struct Panorama {
  int width = 0, height = 0;  ///< pixels
};

/// The direction of a pixel position, unit length.
Eigen::Vector3d direction(const Panorama& panorama, const Eigen::Vector2d& pixel);

/// The longitude of a column, to the right of the middle, and the latitude of a row, upwards from the
/// equator.
double longitude_rad(const Panorama& panorama, double column);
double latitude_rad(const Panorama& panorama, double row);

/// The pixel position of a direction of any positive length; x in [−.5, width − .5).
Eigen::Vector2d pixel(const Panorama& panorama, const Eigen::Vector3d& direction);

}  // namespace cps
