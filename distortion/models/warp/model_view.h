#pragma once

#include <optional>

#include "distortion/crop/true_fov.h"
#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/model_camera.h"
#include "distortion/warp/view_fit.h"

/// Views of cameras of any family: angles seen, and straight cameras for their pictures.
namespace cps {

/// The angles of TrueFov, each for itself: empty where one of its ends lies outside the region.
struct SeenAngles {
  std::optional<double> horizontal_rad = {}, vertical_rad = {}, diagonal_rad = {};
};

/// The angles that the frame really sees, radians, as TrueFov defines them; angles beyond π/2 off the axis
/// count in full (a fisheye may see more than π).
SeenAngles seen_angles(const ModelCamera& camera, const RayRegion& region);

/// The same where the frame sees all of them. Empty if one of the frame's ends lies outside the region.
std::optional<TrueFov> seen_fov(const ModelCamera& camera, const RayRegion& region);

/// The angle between the axis and the farthest ray of the frame's rim, radians; empty if the rim leaves the
/// region.
std::optional<double> farthest_angle_rad(const ModelCamera& camera, const RayRegion& region);

/// Limits of straight pictures: beyond them most of the frame shows a thin ring of the picture.
inline constexpr double farthest_straight_deg = 85;  ///< off the axis, of pictures that Keep::all takes
inline constexpr double widest_straight_deg = 160;   ///< from corner to corner, of Keep::valid

/// The undistorted camera of width × height pixels that straightens a picture of `camera`, as
/// fit_straight_view() does for Brown–Conrady, which this calls for that family. Keep::all refuses cameras
/// that see farthest_straight_deg or more off the axis; Keep::valid shows as much as leaves no pixel without
/// a source, at most widest_straight_deg from corner to corner. Keep::camera has the picture's scale in its
/// middle: the focal lengths times the lens' magnification on the axis, which is 1 / (1 + ξ) for
/// unified_spherical and double_sphere and 1 for the others.
ViewFit fit_straight_view(const ModelCamera& camera, Keep keep, int width, int height, double sigma_px);

/// The camera `wanted`, its focal lengths multiplied by the smallest zoom ≥ 1 with which a kernel of
/// `sigma_px` output pixels lies inside the picture that `source` took everywhere: no black border. Refuses
/// a zoom above `max_zoom`, and lenses that are one-to-one on no part of their frames. As
/// fit_distorted_view() of view_fit.h, which this calls, where the source is undistorted and `wanted`
/// Brown–Conrady.
ViewFit fit_distorted_view(const ModelCamera& source, const ModelCamera& wanted, double sigma_px,
                           double max_zoom);

}  // namespace cps
