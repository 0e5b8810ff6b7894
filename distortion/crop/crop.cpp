#include "distortion/crop/crop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "distortion/certificate/rim_gauge.h"
#include "distortion/inverse/inverse.h"

namespace cps {
namespace {

bool is_inside_frame(const Pinhole& camera, const Eigen::Vector2d& pixel) {
  return pixel.x() > -0.5 && pixel.x() < camera.width - 0.5 && pixel.y() > -0.5 &&
         pixel.y() < camera.height - 0.5;
}

/// Every pixel corner on the frame's rim, in pixels.
std::vector<Eigen::Vector2d> rim_points(const Pinhole& camera) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(2 * (camera.width + camera.height + 2));
  const double right = camera.width - 0.5, bottom = camera.height - 0.5;
  for (int x = 0; x <= camera.width; ++x) points.insert(points.end(), {{x - 0.5, -0.5}, {x - 0.5, bottom}});
  for (int y = 0; y <= camera.height; ++y) points.insert(points.end(), {{-0.5, y - 0.5}, {right, y - 0.5}});
  return points;
}

Crop refused(Crop crop, const std::string& why) {
  crop.valid = false;
  crop.why = why;
  return crop;
}

}  // namespace

std::string CropOptions::fault() const {
  if (!(max_zoom >= 1)) return "max_zoom: must be at least 1";
  if (!(max_magnification >= 1)) return "max_magnification: must be at least 1";
  return certificate.fault();
}

double border_free_zoom(const Distortion& lens, const Pinhole& base,
                        const Eigen::Vector2d& principal_point_px) {
  Pinhole unzoomed = base;
  unzoomed.cx = principal_point_px.x();
  unzoomed.cy = principal_point_px.y();
  // Keeps the touching point inside by a millionth of a pixel, more than rounding can move it.
  constexpr double inwards = 1 + 1e-9;
  return std::max(1.0, inwards / smallest_rim_gauge(lens, frame_on_plane(base), frame_on_plane(unzoomed)));
}

Crop border_free_crop(const Distortion& lens, const Pinhole& base, const Eigen::Vector2d& principal_point_px,
                      const CropOptions& options) {
  Crop crop;
  if (const std::string fault = options.fault(); !fault.empty()) return refused(crop, fault);
  if (base.width <= 0 || base.height <= 0 ||
      !(base.fx > 0 && base.fy > 0 && std::isfinite(base.fx * base.fy)))
    return refused(crop, "the base camera needs a positive size and positive focal lengths");
  const auto [cx, cy] = std::pair(principal_point_px.x(), principal_point_px.y());
  if (!is_inside_frame(base, principal_point_px))
    return refused(crop, fmt::format("the principal point ({:.6g}, {:.6g}) lies outside the {} x {} image",
                                     cx, cy, base.width, base.height));

  const Eigen::AlignedBox2d master = frame_on_plane(base);
  crop.certificate = certify(lens, master, options.certificate);
  if (!crop.certificate.valid) return refused(crop, crop.certificate.why);
  crop.zoom = border_free_zoom(lens, base, principal_point_px);
  crop.camera = {base.width, base.height, base.fx * crop.zoom, base.fy * crop.zoom, cx, cy};
  if (crop.zoom > options.max_zoom)
    return refused(crop, fmt::format("a border-free image needs zoom {:.4g}, above the cap {:.4g}", crop.zoom,
                                     options.max_zoom));
  if (const double magnification = crop.zoom * crop.certificate.max_eigenvalue;
      magnification > options.max_magnification)
    return refused(crop,
                   fmt::format("magnification {:.4g} is above {:.4g}, what the oversampled master carries",
                               magnification, options.max_magnification));

  for (const Eigen::Vector2d& pixel : rim_points(crop.camera)) {
    const Eigen::Vector2d distorted = to_plane(crop.camera, pixel);
    const auto ideal = undistort(lens, master, distorted);
    if (!ideal)
      return refused(
          crop, fmt::format("pixel corner ({:.6g}, {:.6g}) lies outside the master", pixel.x(), pixel.y()));
    const double roundtrip_px = (to_pixel(crop.camera, distort(lens, *ideal)) - pixel).norm();
    crop.worst_roundtrip_px = std::max(crop.worst_roundtrip_px, roundtrip_px);
  }
  crop.valid = true;
  return crop;
}

LabelFirst base_for_final_hfov(const Distortion& scaled, int width, int height, double final_hfov_rad,
                               const Eigen::Vector2d& principal_point_px) {
  const auto half_diagonal = [](const Pinhole& camera) {
    return 0.5 * frame_on_plane(camera).diagonal().norm();
  };
  const Pinhole final_frame = pinhole_from_hfov(width, height, final_hfov_rad);
  const double zoom =
      border_free_zoom(rescaled(scaled, 1 / half_diagonal(final_frame)), final_frame, principal_point_px);
  const Pinhole base = pinhole_from_hfov(width, height, 2 * std::atan(zoom * std::tan(0.5 * final_hfov_rad)));
  return {base, rescaled(scaled, 1 / half_diagonal(base))};
}

}  // namespace cps
