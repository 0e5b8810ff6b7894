#include "sampler/lenses/lens_draw.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "distortion/warp/master_camera.h"
#include "sampler/lenses/real_lens_prior.h"
#include "sampler/lenses/sequential_draw.h"
#include "sampler/lenses/shape_prior.h"
#include "sampler/lenses/tangential_draw.h"

namespace cps {
namespace {

constexpr int max_lens_attempts = 1000;

double half_diagonal(const Pinhole& camera) {
  return 0.5 * frame_on_plane(camera).diagonal().norm();
}

Interval rescaled(const Interval& limits, Coefficient which, double unit) {
  Distortion low, high;
  coefficient(low, which) = limits.low;
  coefficient(high, which) = limits.high;
  return {coefficient(rescaled(low, unit), which), coefficient(rescaled(high, unit), which)};
}

/// Draws the coefficients in units of the half diagonal: `frame` has a half diagonal of 1. False if the lens
/// must be rejected.
bool draw_coefficients(LensScheme scheme, const Pinhole& camera, const Eigen::AlignedBox2d& frame,
                       const LensOptions& options, Stream stream, DrawnLens& lens) {
  const LensBounds& bounds = options.bounds;
  if (scheme == LensScheme::sequential) {
    const double squared_unit = std::pow(half_diagonal(camera), 2);
    CoefficientChoice choice = options.coefficients;
    choice.k1_min *= squared_unit;
    choice.k1_max *= squared_unit;
    const SequentialDraw drawn = draw_sequential(frame, bounds, choice, stream);
    lens.distortion = drawn.lens;
    std::copy(drawn.limits.begin(), drawn.limits.end(), lens.limits.begin());
    return true;
  }
  const Stream radial = make_stream(stream.key, "radial");
  const std::optional<Distortion> drawn = scheme == LensScheme::shape_prior
                                              ? radial_lens(draw_shape(radial))
                                              : draw_real_lens(hfov_rad(camera), radial);
  if (!drawn) return false;
  lens.distortion = *drawn;
  const Eigen::Vector2d tangential =
      draw_tangential(bounds.max_tangential, make_stream(stream.key, "tangential"));
  lens.distortion.p1 = tangential[0];
  lens.distortion.p2 = tangential[1];
  return is_within(bounds, lens.distortion, frame);
}

/// Draws cx and cy and their limits, independent of the H-FOV.
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

/// The scheme of one lens: the chosen one, or one that the options mix in.
LensScheme mixed_scheme(const LensOptions& options, Stream stream) {
  const double u = random_uniform(stream, 0);
  if (u < options.sequential_share) return LensScheme::sequential;
  return u < options.sequential_share + options.real_lenses_share ? LensScheme::real_lenses : options.scheme;
}

DrawnLens draw_once(const Pinhole& camera, CropOrder order, LensScheme scheme, const LensOptions& options,
                    Stream stream) {
  Pinhole unit_camera = camera;  // on its frame the half diagonal is 1
  unit_camera.fx *= half_diagonal(camera);
  unit_camera.fy = unit_camera.fx;
  DrawnLens lens;
  if (!draw_coefficients(scheme, camera, frame_on_plane(unit_camera), options, stream, lens)) {
    lens.crop.why = "the lens drawn from the prior exceeds the bounds";
    return lens;
  }
  const Eigen::Vector2d principal_point =
      draw_principal_point(unit_camera, options.principal_point, stream, lens);
  lens.base = order == CropOrder::base_first
                  ? camera
                  : base_for_final_hfov(lens.distortion, camera.width, camera.height, hfov_rad(camera),
                                        principal_point)
                        .base;
  const double unit = half_diagonal(lens.base);
  lens.distortion = rescaled(lens.distortion, 1 / unit);
  for (Coefficient which : all_coefficients)
    if (auto& limits = lens.limits[static_cast<int>(which)]) limits = rescaled(*limits, which, 1 / unit);
  lens.crop = border_free_crop(lens.distortion, lens.base, principal_point, crop_options(options));
  return lens;
}

}  // namespace

DrawnLens draw_lens(const Pinhole& camera, CropOrder order, const LensOptions& options, Stream stream) {
  if (order == CropOrder::label_first && options.coefficients.has_k1_range())
    throw std::runtime_error("k1_min, k1_max: need the H-FOV of the base, as k1 refers to it");
  // The scheme is chosen once, before any rejection, so that the shares hold among the lenses kept.
  const LensScheme scheme = mixed_scheme(options, make_stream(stream.key, "scheme"));
  std::string why;
  for (int attempt = 0; attempt < max_lens_attempts; ++attempt) {
    DrawnLens lens = draw_once(camera, order, scheme, options, substream(stream, attempt));
    if (lens.crop.valid) return lens;
    why = lens.crop.why;
  }
  throw std::runtime_error("no lens within the bounds in " + std::to_string(max_lens_attempts) +
                           " attempts, the last because " + why +
                           "; widen max_zoom, max_displacement or max_eigenvalue");
}

DrawnLens undistorted_lens(const Pinhole& camera) {
  DrawnLens lens;
  lens.base = camera;
  lens.crop.valid = true;
  lens.crop.camera = camera;
  lens.crop.certificate = certify(lens.distortion, frame_on_plane(camera));
  return lens;
}

}  // namespace cps
