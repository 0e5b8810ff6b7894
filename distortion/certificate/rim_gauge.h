#pragma once

#include <Eigen/Geometry>

#include "distortion/brown_conrady.h"

namespace cps {

/// Gauge of a frame that contains the origin: < 1 inside, 1 on its rim, > 1 outside, proportional along rays.
inline double gauge(const Eigen::AlignedBox2d& frame, const Eigen::Vector2d& point) {
  return std::max(std::max(point.x() / frame.max().x(), point.x() / frame.min().x()),
                  std::max(point.y() / frame.max().y(), point.y() / frame.min().y()));
}

/// Smallest gauge, with respect to `frame`, of the distorted rim of `rectangle`: a lower bound, tight to a
/// relative 1e-11. Where the lens is one-to-one on the rectangle, the frame scaled by the result is the
/// largest copy of it about the origin that the distorted rectangle covers. Both boxes contain the origin in
/// their interior.
double smallest_rim_gauge(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                          const Eigen::AlignedBox2d& frame);

}  // namespace cps
