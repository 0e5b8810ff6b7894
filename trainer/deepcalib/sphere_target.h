#pragma once

#include <array>
#include <span>
#include <string>

#include "distortion/models/model_camera.h"
#include "numbers/interval.h"

/// The two numbers that DeepCalib (Bogdan, Eckstein, Rameau, Bazin 2018) reads from an image: the focal
/// length and ξ of a unified spherical lens whose principal point is the image's middle.
namespace cps {

/// The image width for which focal lengths are stated, pixels.
inline constexpr double deepcalib_width_px = 299;
/// What the networks can say: focal lengths at that width, and ξ.
inline constexpr Interval deepcalib_focal_px{50, 500}, deepcalib_xi{0, 1.2};

/// A focal length (Mei's γ, UnifiedSpherical) and ξ, each as a share of its interval: 0 at the low end, 1 at
/// the high one.
struct SphereTarget {
  double focal = 0, xi = 0;
  bool operator==(const SphereTarget&) const = default;
};

/// In the order of SphereTarget.
inline constexpr std::array<const char*, 2> sphere_output_names{"focal", "xi"};

/// The target that describes the camera: unified_spherical without distortion on its plane, or undistorted
/// (ξ = 0), square pixels, a principal point in the middle, both numbers within their intervals. Throws
/// std::runtime_error in one line that starts with `label`, the name of the label file, for any other camera.
SphereTarget to_sphere_target(const ModelCamera& camera, const std::string& label);

/// The camera (without a name) that the target describes for an image of this size in pixels. Its pixels are
/// square, so the image keeps its aspect ratio when it is reduced.
ModelCamera to_model_camera(const SphereTarget& target, int width, int height);

/// The angle that such an image sees along its middle row, radians: seen_hfov_rad() in closed form, or twice
/// the largest angle that the lens shows where it does not fill the row.
double seen_hfov_rad(const SphereTarget& target, int width);

/// Mean and standard deviation of targets; a deviation is 1 where they do not vary.
struct SphereStatistics {
  SphereTarget mean, deviation{1, 1};
};

/// Over at least one target.
SphereStatistics sphere_statistics(std::span<const SphereTarget> targets);

}  // namespace cps
