#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/certificate/rim_gauge.h"

namespace cps {

/// The search of certify_frame() for any lens of the plane that has certify(), is_certified() and
/// smallest_rim_gauge().
template <typename Lens>
FrameCertificate certify_grown_rectangle(const Lens& lens, const Pinhole& camera,
                                         const Eigen::AlignedBox2d& shape,
                                         const CertificateOptions& options) {
  const auto contains_principal_point = [](const Eigen::AlignedBox2d& box) {
    return (box.min().array() < 0).all() && (box.max().array() > 0).all();
  };
  const auto scaled_box = [&](double scale) {
    return Eigen::AlignedBox2d(scale * shape.min(), scale * shape.max());
  };
  FrameCertificate result;
  const auto refused = [&](const std::string& why) {
    result.why = why;
    return result;
  };
  if (camera.width <= 0 || camera.height <= 0) return refused("width, height: must be positive");
  if (!(camera.fx > 0 && camera.fy > 0 && std::isfinite(camera.fx) && std::isfinite(camera.fy)))
    return refused("fx, fy: must be positive and finite");
  const Eigen::AlignedBox2d frame = frame_on_plane(camera);
  if (!contains_principal_point(frame) || !contains_principal_point(shape))
    return refused("cx, cy: the principal point lies outside the image");

  const auto gauge_at = [&](double scale) { return smallest_rim_gauge(lens, scaled_box(scale), frame); };
  // Grow a rectangle, at first far smaller than any lens needs, in steps of 2 % until its image contains the
  // frame or the lens is no longer certified on it.
  constexpr double step = 1.02, first = 0.2;
  double outside = first, reach = 0;
  while (reach < 1) {
    if (!is_certified(lens, scaled_box(outside), options)) break;
    reach = std::max(reach, gauge_at(outside));
    if (reach < 1) outside *= step;
  }
  if (reach < 1) {
    // The lens stops being certified between the last step and this one, perhaps only beyond the frame:
    // bisect.
    double certified = outside == first ? 0 : outside / step, refused_at = outside;
    while (refused_at - certified > 1e-9 * refused_at) {
      const double middle = 0.5 * (certified + refused_at);
      (is_certified(lens, scaled_box(middle), options) ? certified : refused_at) = middle;
    }
    reach = certified > 0 ? gauge_at(certified) : 0;
    if (reach < 1) {
      result.rectangle = scaled_box(certified);
      result.certificate = certify(lens, result.rectangle, options);
      return refused(
          fmt::format("the lens cannot be certified on all of the frame, only {:.2f} % of the way: {}",
                      100 * reach, certify(lens, scaled_box(outside), options).why));
    }
    outside = certified;
  }
  double inside = outside > first ? outside / step : 0;
  while (outside - inside > 1e-9 * outside) {
    const double middle = 0.5 * (inside + outside);
    (gauge_at(middle) >= 1 ? outside : inside) = middle;
  }
  result.rectangle = scaled_box(outside);
  result.certificate = certify(lens, result.rectangle, options);
  result.why = result.certificate.why;
  return result;
}

}  // namespace cps
