#include "sampler/lens_draw.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "distortion/warp.h"
#include "sampler/sequential_draw.h"
#include "sampler/shape_prior.h"

namespace cps {
namespace {

constexpr int max_attempts = 1000;

double half_diagonal(const Pinhole& camera) {
  return 0.5 * frame_on_plane(camera).diagonal().norm();
}

Interval rescaled(const Interval& limits, Coefficient which, double unit) {
  Distortion low, high;
  coefficient(low, which) = limits.low;
  coefficient(high, which) = limits.high;
  return {coefficient(rescaled(low, unit), which), coefficient(rescaled(high, unit), which)};
}

/// The coefficients in units of the half diagonal, on the frame that has 1 of them; false if the draw is to
/// be rejected.
bool draw_coefficients(LensScheme scheme, const Eigen::AlignedBox2d& frame, const LensBounds& bounds,
                       Stream stream, DrawnLens& lens) {
  if (scheme == LensScheme::sequential) {
    const SequentialDraw drawn = draw_sequential(frame, bounds, stream);
    lens.distortion = drawn.lens;
    std::copy(drawn.limits.begin(), drawn.limits.end(), lens.limits.begin());
    return true;
  }
  const std::optional<Distortion> drawn = draw_from_shape_prior(bounds.max_tangential, stream);
  if (!drawn || !is_within(bounds, *drawn, frame)) return false;
  lens.distortion = *drawn;
  return true;
}

/// Draws cx and cy and their limits. Nothing of it depends on the H-FOV.
Eigen::Vector2d draw_principal_point(const Pinhole& unit_camera, const PrincipalPointBounds& bounds,
                                     Stream stream, DrawnLens& lens) {
  const Stream values = make_stream(stream.key, "principal point");
  Eigen::Vector2d principal_point(unit_camera.cx, unit_camera.cy);
  for (int axis : drawn_order<2>(make_stream(stream.key, "axis order"))) {
    const Interval limits =
        principal_point_limits(lens.distortion, unit_camera, principal_point,
                               axis == 0 ? PrincipalPointAxis::cx : PrincipalPointAxis::cy, bounds);
    principal_point[axis] = random_uniform(values, axis, limits.low, limits.high);
    lens.limits[5 + axis] = limits;
  }
  return principal_point;
}

CropOptions crop_options(const LensOptions& options) {
  return {.max_zoom = options.principal_point.max_zoom,
          .max_magnification = largest_magnification(WarpOptions{}),
          .certificate = {.min_eigenvalue = options.bounds.min_eigenvalue,
                          .max_eigenvalue = options.bounds.max_eigenvalue}};
}

DrawnLens draw_once(const Pinhole& base, LensScheme scheme, const LensOptions& options, Stream stream) {
  const double unit = half_diagonal(base);
  Pinhole unit_camera = base;
  unit_camera.fx *= unit;
  unit_camera.fy *= unit;
  DrawnLens lens;
  if (!draw_coefficients(scheme, frame_on_plane(unit_camera), options.bounds, stream, lens)) {
    lens.crop.why = "the lens drawn from the prior exceeds the bounds";
    return lens;
  }
  const Eigen::Vector2d principal_point =
      draw_principal_point(unit_camera, options.principal_point, stream, lens);
  lens.distortion = rescaled(lens.distortion, 1 / unit);
  constexpr Coefficient coefficients[] = {Coefficient::k1, Coefficient::k2, Coefficient::k3, Coefficient::p1,
                                          Coefficient::p2};
  for (Coefficient which : coefficients)
    if (auto& limits = lens.limits[static_cast<int>(which)]) limits = rescaled(*limits, which, 1 / unit);
  lens.crop = border_free_crop(lens.distortion, base, principal_point, crop_options(options));
  return lens;
}

}  // namespace

DrawnLens draw_lens(const Pinhole& base, const LensOptions& options, Stream stream) {
  // Chosen once, before any rejection, so that the share is that of the lenses kept.
  const bool for_coverage = random_uniform(make_stream(stream.key, "scheme"), 0) < options.sequential_share;
  const LensScheme scheme = for_coverage ? LensScheme::sequential : options.scheme;
  std::string why;
  for (int attempt = 0; attempt < max_attempts; ++attempt) {
    DrawnLens lens = draw_once(base, scheme, options, substream(stream, attempt));
    if (lens.crop.valid) return lens;
    why = lens.crop.why;
  }
  throw std::runtime_error("no lens within the bounds in " + std::to_string(max_attempts) +
                           " attempts, the last because " + why +
                           "; widen max_zoom, max_displacement or max_eigenvalue");
}

DrawnLens undistorted_lens(const Pinhole& base) {
  DrawnLens lens;
  lens.crop.valid = true;
  lens.crop.camera = base;
  return lens;
}

}  // namespace cps
