#include "distortion/models/warp/model_view.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "distortion/models/warp/model_footprints.h"
#include "distortion/warp/rim_coverage.h"
#include "distortion/warp/warp_options.h"
#include "numbers/angles.h"

namespace cps {
namespace {

ViewFit refused(const std::string& why) {
  return {.valid = false, .camera = {}, .why = why};
}

double angle_from_axis(const Eigen::Vector3d& ray) {
  return std::atan2(std::hypot(ray.x(), ray.y()), ray.z());
}

/// The angle between two rays on opposite sides of the axis, along the arc that passes the axis: the long one
/// where the middle of the short one lies behind the camera.
double angle_past_axis(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double shorter = std::atan2(a.cross(b).norm(), a.dot(b));
  return a.z() + b.z() >= 0 ? shorter : 2 * std::numbers::pi - shorter;
}

/// Calls use(corner) for every corner of a pixel that lies on the frame's rim.
template <typename Use>
void for_each_rim_corner(const Pinhole& camera, const Use& use) {
  const double left = -0.5, top = -0.5, right = camera.width - 0.5, bottom = camera.height - 0.5;
  for (int x = 0; x <= camera.width; ++x)
    for (const double y : {top, bottom}) use(Eigen::Vector2d(x - 0.5, y));
  for (int y = 0; y <= camera.height; ++y)
    for (const double x : {left, right}) use(Eigen::Vector2d(x, y - 0.5));
}

/// How far a picture sees.
struct SeenExtent {
  double angle_rad = 0;                                ///< from the axis
  Eigen::Vector2d on_plane = Eigen::Vector2d::Zero();  ///< |x| and |y| on the plane z = 1
};

/// Of the part of the frame whose rays lie in the region: its rim, if the region has the whole frame,
/// otherwise every pixel corner.
SeenExtent seen_extent(const ModelCamera& camera, const ModelCertificate& proof) {
  SeenExtent extent;
  const auto extend = [&](const Eigen::Vector2d& pixel) {
    const auto ray = unproject(camera.lens, proof.region, to_plane(camera.pinhole, pixel));
    if (!ray) return;
    extent.angle_rad = std::max(extent.angle_rad, angle_from_axis(*ray));
    if (ray->z() > 0)
      extent.on_plane = extent.on_plane.cwiseMax(ray->hnormalized().cwiseAbs());
    else
      extent.on_plane.setConstant(std::numeric_limits<double>::infinity());
  };
  for_each_rim_corner(camera.pinhole, extend);
  if (!proof.valid)
    for (int y = 1; y < camera.pinhole.height; ++y)
      for (int x = 1; x < camera.pinhole.width; ++x) extend(Eigen::Vector2d(x - 0.5, y - 0.5));
  return extent;
}

/// The smallest zoom of `view`, at least 1, that leaves no pixel without a source.
double covered_zoom(const ProvedCamera& source, const ProvedCamera& view, double sigma_px) {
  const Pinhole& seen = source.camera.pinhole;
  const ViewFootprints footprints = [&](const Pinhole& zoomed_view, const TileRect& rect,
                                        FootprintTile& tile) {
    ProvedCamera output = view;
    output.camera.pinhole = zoomed_view;
    model_footprints(source, output, sigma_px, rect, tile);
  };
  return smallest_covered_zoom(footprints, view.camera.pinhole, {seen.width, seen.height}, 1);
}

/// The straight camera whose middle shows things as large as the picture's middle does.
Pinhole straight_middle(const ModelCamera& camera) {
  const ProjectedRay middle = project(camera.lens, Eigen::Vector3d::UnitZ());
  Pinhole result = camera.pinhole;
  result.fx *= middle.jacobian(0, 0);
  result.fy *= middle.jacobian(1, 1);
  return result;
}

}  // namespace

SeenAngles seen_angles(const ModelCamera& camera, const RayRegion& region) {
  const Pinhole& pinhole = camera.pinhole;
  const double left = -0.5, top = -0.5, right = pinhole.width - 0.5, bottom = pinhole.height - 0.5;
  const auto angle = [&](const Eigen::Vector2d& pixel_a,
                         const Eigen::Vector2d& pixel_b) -> std::optional<double> {
    const auto a = unproject(camera.lens, region, to_plane(pinhole, pixel_a)),
               b = unproject(camera.lens, region, to_plane(pinhole, pixel_b));
    if (!a || !b) return std::nullopt;
    return angle_past_axis(*a, *b);
  };
  const auto falling = angle({left, top}, {right, bottom}), rising = angle({left, bottom}, {right, top});
  SeenAngles seen{.horizontal_rad = angle({left, pinhole.cy}, {right, pinhole.cy}),
                  .vertical_rad = angle({pinhole.cx, top}, {pinhole.cx, bottom})};
  if (falling && rising) seen.diagonal_rad = std::max(*falling, *rising);
  return seen;
}

std::optional<TrueFov> seen_fov(const ModelCamera& camera, const RayRegion& region) {
  if (const auto* lens = std::get_if<Distortion>(&camera.lens); lens && region.box)
    return true_fov(*lens, camera.pinhole, *region.box);
  const SeenAngles seen = seen_angles(camera, region);
  if (!seen.horizontal_rad || !seen.vertical_rad || !seen.diagonal_rad) return std::nullopt;
  return TrueFov{*seen.horizontal_rad, *seen.vertical_rad, *seen.diagonal_rad};
}

std::optional<double> farthest_angle_rad(const ModelCamera& camera, const RayRegion& region) {
  std::optional<double> farthest = 0;
  for_each_rim_corner(camera.pinhole, [&](const Eigen::Vector2d& pixel) {
    if (!farthest) return;
    const auto ray = unproject(camera.lens, region, to_plane(camera.pinhole, pixel));
    farthest = ray ? std::optional(std::max(*farthest, angle_from_axis(*ray))) : std::nullopt;
  });
  return farthest;
}

ViewFit fit_straight_view(const ModelCamera& camera, Keep keep, int width, int height, double sigma_px) {
  if (const auto* lens = std::get_if<Distortion>(&camera.lens))
    return fit_straight_view(CalibratedCamera{camera.name, camera.pinhole, *lens}, keep, width, height,
                             sigma_px);
  const ModelCertificate proof = certify_frame(camera, warpable);
  if (is_empty(proof.region)) return refused(proof.why);
  if (keep == Keep::camera)
    return {.valid = true, .camera = straight_middle(resized(camera, width, height)), .why = {}};

  const SeenExtent extent = seen_extent(camera, proof);
  if (keep == Keep::all && extent.angle_rad >= radians(farthest_straight_deg))
    return refused(
        fmt::format("the picture sees {:.1f} degrees off the axis, a straight one below {:g}: keep "
                    "the valid part only, or convert to another fisheye",
                    degrees(extent.angle_rad), farthest_straight_deg));
  double focal = std::min(0.5 * width / extent.on_plane.x(), 0.5 * height / extent.on_plane.y());
  if (keep == Keep::valid)
    focal = std::max(focal, 0.5 * std::hypot(width, height) / std::tan(0.5 * radians(widest_straight_deg)));
  if (!std::isfinite(focal)) return refused("no part of the picture fills a frame");
  const Pinhole widest{.width = width,
                       .height = height,
                       .fx = focal,
                       .fy = focal,
                       .cx = 0.5 * (width - 1),
                       .cy = 0.5 * (height - 1)};
  if (keep == Keep::all) return {.valid = true, .camera = widest, .why = {}};

  const double zoom =
      covered_zoom({camera, proof.region}, proved_camera({{}, widest, Distortion{}}), sigma_px);
  if (!std::isfinite(zoom)) return refused("no part of the picture fills a frame");
  return {.valid = true, .camera = zoomed(widest, zoom), .why = {}};
}

ViewFit fit_distorted_view(const ModelCamera& source, const ModelCamera& wanted, double sigma_px,
                           double max_zoom) {
  const auto* lens = std::get_if<Distortion>(&wanted.lens);
  if (lens && source.lens == LensModel(Distortion{}))
    return fit_distorted_view(source.pinhole, CalibratedCamera{wanted.name, wanted.pinhole, *lens}, sigma_px,
                              max_zoom);
  const ModelCertificate seen = certify_frame(source, warpable), shown = certify_frame(wanted, warpable);
  if (is_empty(seen.region)) return refused(seen.why);
  if (is_empty(shown.region)) return refused(shown.why);
  const double zoom = covered_zoom({source, seen.region}, {wanted, shown.region}, sigma_px);
  if (!(zoom <= max_zoom))
    return refused(fmt::format(
        "an image without black border needs zoom {:.4g}, above the cap {:.4g}: take a wider source", zoom,
        max_zoom));
  return {.valid = true, .camera = zoomed(wanted.pinhole, zoom), .why = {}};
}

}  // namespace cps
