#include "distortion/warp/view_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/certificate/rim_gauge.h"
#include "distortion/inverse/inverse.h"
#include "distortion/label_algebra.h"
#include "distortion/warp/footprints.h"
#include "distortion/warp/rim_coverage.h"
#include "distortion/warp/warp_options.h"

namespace cps {
namespace {

ViewFit refused(const std::string& why) {
  return {.valid = false, .camera = {}, .why = why};
}

/// Footprints of views through a geometry's lens, whatever its own output.
template <typename MakeFootprints>
ViewFootprints view_footprints(const MakeFootprints& make_footprints, const ResamplingGeometry& geometry) {
  return [=](const Pinhole& view, const TileRect& rect, FootprintTile& tile) {
    ResamplingGeometry of_view = geometry;
    of_view.output = view;
    make_footprints(of_view, rect, tile);
  };
}

}  // namespace

ViewFit fit_distorted_view(const Pinhole& source, const CalibratedCamera& wanted, double sigma_px,
                           double max_zoom) {
  const Eigen::AlignedBox2d shown = frame_on_plane(source);
  const FrameCertificate proof = certify_frame(wanted.distortion, wanted.pinhole, shown, warpable);
  if (!proof.certificate.valid) return refused(proof.why);
  const Eigen::AlignedBox2d usable = proof.rectangle.intersection(shown);
  const double border_free =
      1 / smallest_rim_gauge(wanted.distortion, usable, frame_on_plane(wanted.pinhole));
  const bool shows_enough = proof.valid() && shown.contains(proof.rectangle);
  const double zoom = smallest_covered_zoom(
      view_footprints(distorting_footprints, {wanted.distortion, usable, source, wanted.pinhole, sigma_px}),
      wanted.pinhole, {source.width, source.height},
      shows_enough ? 1.0 : std::max(1.0, border_free * (1 + 1e-9)));
  if (!(zoom <= max_zoom))
    return refused(fmt::format(
        "an image without black border needs zoom {:.4g}, above the cap {:.4g}: render a wider source", zoom,
        max_zoom));
  return {.valid = true, .camera = zoomed(wanted.pinhole, zoom), .why = {}};
}

ViewFit fit_straight_view(const CalibratedCamera& source, Keep keep, int width, int height, double sigma_px) {
  const FrameCertificate proof = certify_frame(source.distortion, source.pinhole, warpable);
  if (!proof.certificate.valid) return refused(proof.why);
  if (keep == Keep::camera) {
    const CalibratedCamera scaled = resized(source, width, height);
    return {.valid = true, .camera = scaled.pinhole, .why = {}};
  }

  // Half extent of everything the source shows (of its certified part, where the whole is not certified):
  // decides the zoom of Keep::all, and is where the search for Keep::valid starts.
  const Pinhole& camera = source.pinhole;
  Eigen::Vector2d farthest = Eigen::Vector2d::Zero();
  if (!proof.valid()) farthest = proof.rectangle.min().cwiseAbs().cwiseMax(proof.rectangle.max());
  const auto extend = [&](double x, double y) {
    if (const auto ideal = undistort(source.distortion, proof.rectangle, to_plane(camera, {x, y})))
      farthest = farthest.cwiseMax(ideal->cwiseAbs());
  };
  for (int x = 0; x <= camera.width; ++x) extend(x - 0.5, -0.5), extend(x - 0.5, camera.height - 0.5);
  for (int y = 0; y <= camera.height; ++y) extend(-0.5, y - 0.5), extend(camera.width - 0.5, y - 0.5);
  const double all = std::min(0.5 * width / farthest.x(), 0.5 * height / farthest.y());
  const Pinhole everything{.width = width,
                           .height = height,
                           .fx = all,
                           .fy = all,
                           .cx = 0.5 * (width - 1),
                           .cy = 0.5 * (height - 1)};
  if (keep == Keep::all) return {.valid = true, .camera = everything, .why = {}};

  const double zoom = smallest_covered_zoom(
      view_footprints(undistorting_footprints,
                      {source.distortion, proof.rectangle, camera, everything, sigma_px}),
      everything, {camera.width, camera.height}, 1);
  if (!std::isfinite(zoom)) return refused("no part of the picture fills a frame");
  return {.valid = true, .camera = zoomed(everything, zoom), .why = {}};
}

}  // namespace cps
