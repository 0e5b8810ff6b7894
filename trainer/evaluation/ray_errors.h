#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "trainer/calibration/ray_truth.h"

/// Errors of a predicted camera of any lens family against a true one of any: parameters of two families
/// cannot be compared, the rays of their pixels can.
namespace cps {

/// The rotation that takes `from` nearest to `to` in the mean square (Kabsch 1976; Wahba 1965): unit vectors,
/// entry i of both belongs together.
Eigen::Matrix3d nearest_rotation(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to);

/// Angles between the true and the predicted rays of pixels, degrees.
struct RayAngles {
  double mean_deg = 0;
  double p95_deg = 0;  ///< 95 % quantile over the pixels
  /// Mean after nearest_rotation() of the predicted rays: what no turn of the camera makes up for. A wrong
  /// principal point, or a tilt of the rays, is mostly such a turn.
  double turned_mean_deg = 0;
};

/// Of unit rays; entry i of both belongs to one pixel, of which there is at least one.
RayAngles angles_between(std::span<const Eigen::Vector3d> truth, std::span<const Eigen::Vector3d> predicted);

/// Errors of one prediction.
struct RayErrors {
  /// Empty: no camera, or a lens that is not proved one-to-one on its frame, so that some pixel of the frame
  /// shows several rays or none.
  std::optional<RayAngles> angles;
  /// Mean distance between where the true and the predicted camera show the true rays; empty: no camera, or
  /// one that cannot show some of them (angle_limit()).
  std::optional<double> reprojection_px;
  std::optional<double> seen_hfov_deg;  ///< |predicted − true|; empty where one of the two has none
};

/// Compares the prediction, empty if it is not a camera, with the truth.
RayErrors ray_errors(const RayTruth& truth, const std::optional<ModelCamera>& predicted);

}  // namespace cps
