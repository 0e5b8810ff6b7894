#include "distortion/warp/view_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/certificate/rim_gauge.h"
#include "distortion/inverse/inverse.h"
#include "distortion/label_algebra.h"
#include "distortion/warp/footprints.h"
#include "distortion/warp/pixel_bounds.h"
#include "distortion/warp/warp_options.h"

namespace cps {
namespace {

ViewFit refused(const std::string& why) {
  return {.valid = false, .camera = {}, .why = why};
}

/// One of distorting_footprints and undistorting_footprints.
using MakeFootprints = void (*)(const ResamplingGeometry& geometry, const TileRect& rect,
                                FootprintTile& tile);

/// Whether every pixel on the output's rim finds its whole footprint in the source; the pixels inside the rim
/// then do too.
bool is_rim_covered(MakeFootprints make_footprints, const ResamplingGeometry& geometry) {
  constexpr int side = FootprintTile::side;
  const Pinhole &output = geometry.output, &source = geometry.source;
  const auto tile = std::make_unique<FootprintTile>();
  const auto is_covered = [&](const TileRect& rect) {
    make_footprints(geometry, rect, *tile);
    BoundsRow bounds;
    for (int row = 0; row < rect.height; ++row)
      if (find_bounds(*tile, row, source.width, source.height, bounds) > 0) return false;
    return true;
  };
  for (int x0 = 0; x0 < output.width; x0 += side) {
    const int width = std::min(side, output.width - x0);
    if (!is_covered({x0, 0, width, 1}) || !is_covered({x0, output.height - 1, width, 1})) return false;
  }
  for (int y0 = 0; y0 < output.height; y0 += side) {
    const int height = std::min(side, output.height - y0);
    if (!is_covered({0, y0, 1, height}) || !is_covered({output.width - 1, y0, 1, height})) return false;
  }
  return true;
}

Pinhole zoomed(const Pinhole& camera, double zoom) {
  Pinhole result = camera;
  result.fx *= zoom;
  result.fy *= zoom;
  return result;
}

/// The smallest zoom of the output, at least `min_zoom`, at which its rim is covered; infinite if none is
/// below 1000 · min_zoom.
double smallest_covered_zoom(MakeFootprints make_footprints, const ResamplingGeometry& geometry,
                             double min_zoom) {
  const auto is_covered = [&](double zoom) {
    ResamplingGeometry at_zoom = geometry;
    at_zoom.output = zoomed(geometry.output, zoom);
    return is_rim_covered(make_footprints, at_zoom);
  };
  if (is_covered(min_zoom)) return min_zoom;
  double low = min_zoom, high = 1.01 * min_zoom;
  while (!is_covered(high)) {
    low = high;
    high *= 1.05;
    if (high > 1000 * min_zoom) return std::numeric_limits<double>::infinity();
  }
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (is_covered(middle) ? high : low) = middle;
  }
  return high;
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
  const double zoom = smallest_covered_zoom(distorting_footprints,
                                            {wanted.distortion, usable, source, wanted.pinhole, sigma_px},
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
      undistorting_footprints, {source.distortion, proof.rectangle, camera, everything, sigma_px}, 1);
  if (!std::isfinite(zoom)) return refused("no part of the picture fills a frame");
  return {.valid = true, .camera = zoomed(everything, zoom), .why = {}};
}

}  // namespace cps
