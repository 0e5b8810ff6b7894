#pragma once

#include <Eigen/Geometry>

#include "distortion/brown_conrady.h"

namespace cps {

/// Gauge of a frame that contains the origin (Minkowski functional): 1 on its rim, and proportional to the
/// distance along every ray from the origin, so < 1 inside and > 1 outside.
inline double gauge(const Eigen::AlignedBox2d& frame, const Eigen::Vector2d& point) {
  return std::max(std::max(point.x() / frame.max().x(), point.x() / frame.min().x()),
                  std::max(point.y() / frame.max().y(), point.y() / frame.min().y()));
}

/// Lower bound, tight to a relative 1e-11, on the gauge with respect to `frame` over the distorted rim of
/// `rectangle`. If the lens is one-to-one on the rectangle, `frame` scaled by the result is the largest copy
/// of the frame about the origin that the distorted rectangle covers. Both boxes must contain the origin in
/// their interior.
double smallest_rim_gauge(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                          const Eigen::AlignedBox2d& frame);

}  // namespace cps
