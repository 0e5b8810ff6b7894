#pragma once

#include <map>
#include <string>
#include <string_view>

#include "distortion/models/model_camera.h"

namespace cps {

/// A camera of another family fitted to a given one.
struct ConvertedCamera {
  ModelCamera camera;
  /// Reprojection error over a grid of the frame's pixels, pixels of the image: the same ray, both cameras.
  double rms_px = 0, worst_px = 0;
  double worst_angle_rad = 0;  ///< largest angle between the rays of one pixel
  double covered = 1;          ///< share of the grid's rays that the new camera shows inside its own frame
  std::string why;             ///< empty, or one line why there is no result
};

/// Fits a camera of `family` to `camera`: focal lengths, principal point and the family's parameters minimise
/// the squared reprojection error over a grid of 31 × 31 of the frame's rays, from the first pixel's centre
/// to the last one's (Levenberg–Marquardt from a closed-form start, parameters kept in the family's range). A
/// lens without tangential terms keeps its principal point, the ratio of its focal lengths, and no tangential
/// terms. Where the family contains the lens (its own; brown_conrady in rational and in unified_spherical),
/// the result is the same lens, exactly. `held` fixes parameters of the family by name: with k1, k2, k3, p1
/// and p2 at 0, unified_spherical has ξ alone.
///
/// Refused (`why`): a camera whose lens is not proved on its frame, a family of the plane for a camera that
/// sees 85° or more off the axis, a family that does not reach the camera's angles with what is held, a
/// result that is not proved on its own frame. Throws std::runtime_error in one line for an unknown family,
/// and for held parameters that it does not have or that are out of range.
ConvertedCamera convert(const ModelCamera& camera, std::string_view family,
                        const std::map<std::string, double>& held = {});

}  // namespace cps
