#include "sampler/lens_draw.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "distortion/warp.h"

namespace cps {
namespace {

constexpr int max_attempts = 1000;

/// 0 … count−1 in an order drawn from `stream` (Fisher–Yates).
template <std::size_t count>
std::array<int, count> drawn_order(Stream stream) {
  std::array<int, count> order;
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<int>(i);
  for (std::size_t i = count - 1; i > 0; --i) std::swap(order[i], order[random_below(stream, i, i + 1)]);
  return order;
}

DrawnLens draw_once(const Pinhole& base, const Eigen::AlignedBox2d& padded_master, const LensBounds& bounds,
                    const PrincipalPointBounds& principal_point_bounds, Stream stream) {
  DrawnLens lens;
  const Stream values = make_stream(stream.key, "values");
  constexpr Coefficient coefficients[] = {Coefficient::k1, Coefficient::k2, Coefficient::k3, Coefficient::p1,
                                          Coefficient::p2};
  for (int which : drawn_order<5>(make_stream(stream.key, "coefficient order"))) {
    const Interval limits = coefficient_limits(lens.distortion, coefficients[which], padded_master, bounds);
    coefficient(lens.distortion, coefficients[which]) =
        random_uniform(values, which, limits.low, limits.high);
    lens.limits[which] = limits;
  }
  Eigen::Vector2d principal_point(base.cx, base.cy);
  for (int axis : drawn_order<2>(make_stream(stream.key, "axis order"))) {
    const Interval limits = principal_point_limits(
        lens.distortion, base, principal_point, axis == 0 ? PrincipalPointAxis::cx : PrincipalPointAxis::cy,
        principal_point_bounds);
    principal_point[axis] = random_uniform(values, 5 + axis, limits.low, limits.high);
    lens.limits[5 + axis] = limits;
  }
  lens.crop = border_free_crop(
      lens.distortion, base, principal_point,
      {.max_zoom = principal_point_bounds.max_zoom,
       .max_magnification = largest_magnification(WarpOptions{}),
       .certificate = {.min_eigenvalue = bounds.min_eigenvalue, .max_eigenvalue = bounds.max_eigenvalue}});
  return lens;
}

}  // namespace

DrawnLens draw_lens(const Pinhole& base, const Eigen::AlignedBox2d& padded_master, const LensBounds& bounds,
                    const PrincipalPointBounds& principal_point_bounds, Stream stream) {
  std::string why;
  for (int attempt = 0; attempt < max_attempts; ++attempt) {
    DrawnLens lens =
        draw_once(base, padded_master, bounds, principal_point_bounds, substream(stream, attempt));
    if (lens.crop.valid) return lens;
    why = lens.crop.why;
  }
  throw std::runtime_error("no lens within the bounds in " + std::to_string(max_attempts) +
                           " attempts, the last because " + why +
                           "; widen max_zoom or max_eigenvalue, or lower max_displacement");
}

DrawnLens undistorted_lens(const Pinhole& base) {
  DrawnLens lens;
  lens.crop.valid = true;
  lens.crop.camera = base;
  return lens;
}

}  // namespace cps
