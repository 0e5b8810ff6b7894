#include "distortion/warp/view_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/certificate/rim_gauge.h"
#include "distortion/inverse/inverse.h"
#include "distortion/label_algebra.h"
#include "distortion/warp/footprints.h"
#include "distortion/warp/gather.h"
#include "distortion/warp/warp.h"

namespace cps {
namespace {

ViewFit refused(const std::string& why) {
  return {.valid = false, .camera = {}, .why = why};
}

/// Fills the footprints of one tile of the output at `camera`.
using FootprintsAt =
    std::function<void(const Pinhole& camera, int x0, int y0, int width, int height, FootprintTile& tile)>;

/// Whether every pixel on the frame's rim finds its whole footprint in the source; those inside it then do
/// too.
bool is_rim_covered(const FootprintsAt& footprints, const Pinhole& camera, const Pinhole& source) {
  constexpr int side = FootprintTile::side;
  const auto tile = std::make_unique<FootprintTile>();
  const auto is_covered = [&](int x0, int y0, int width, int height) {
    footprints(camera, x0, y0, width, height, *tile);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        if (!is_footprint_inside(*tile, row * side + column, source.width, source.height)) return false;
      }
    return true;
  };
  for (int x0 = 0; x0 < camera.width; x0 += side) {
    const int width = std::min(side, camera.width - x0);
    if (!is_covered(x0, 0, width, 1) || !is_covered(x0, camera.height - 1, width, 1)) return false;
  }
  for (int y0 = 0; y0 < camera.height; y0 += side) {
    const int height = std::min(side, camera.height - y0);
    if (!is_covered(0, y0, 1, height) || !is_covered(camera.width - 1, y0, 1, height)) return false;
  }
  return true;
}

Pinhole zoomed(const Pinhole& camera, double zoom) {
  Pinhole result = camera;
  result.fx *= zoom;
  result.fy *= zoom;
  return result;
}

/// The smallest zoom ≥ `least` at which the rim is covered; infinite if none is below 1000 times that.
double smallest_covered_zoom(const FootprintsAt& footprints, const Pinhole& camera, const Pinhole& source,
                             double least) {
  const auto is_covered = [&](double zoom) {
    return is_rim_covered(footprints, zoomed(camera, zoom), source);
  };
  if (is_covered(least)) return least;
  double low = least, high = 1.01 * least;
  while (!is_covered(high)) {
    low = high;
    high *= 1.05;
    if (high > 1000 * least) return std::numeric_limits<double>::infinity();
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
  const FootprintsAt footprints = [&](const Pinhole& camera, int x0, int y0, int width, int height,
                                      FootprintTile& tile) {
    distorting_footprints(wanted.distortion, usable, source, camera, sigma_px, x0, y0, width, height, tile);
  };
  const bool shows_enough = proof.valid() && shown.contains(proof.rectangle);
  const double zoom = smallest_covered_zoom(footprints, wanted.pinhole, source,
                                            shows_enough ? 1.0 : std::max(1.0, border_free * (1 + 1e-9)));
  if (!(zoom <= max_zoom)) {
    char line[160];
    std::snprintf(line, sizeof line,
                  "an image without black border needs zoom %.4g, above the cap %.4g: render a wider source",
                  zoom, max_zoom);
    return refused(line);
  }
  return {.valid = true, .camera = zoomed(wanted.pinhole, zoom), .why = {}};
}

ViewFit fit_straight_view(const CalibratedCamera& source, Keep keep, int width, int height, double sigma_px) {
  const FrameCertificate proof = certify_frame(source.distortion, source.pinhole, warpable);
  if (!proof.certificate.valid) return refused(proof.why);
  if (keep == Keep::camera) {
    const CalibratedCamera scaled = resized(source, width, height);
    return {.valid = true, .camera = scaled.pinhole, .why = {}};
  }

  // The widest extent of what the source shows, or of what is proved of it, decides Keep::all, and is a start
  // for Keep::valid.
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

  const FootprintsAt footprints = [&](const Pinhole& output, int x0, int y0, int tile_width, int tile_height,
                                      FootprintTile& tile) {
    undistorting_footprints(source.distortion, proof.rectangle, camera, output, sigma_px, x0, y0, tile_width,
                            tile_height, tile);
  };
  const double zoom = smallest_covered_zoom(footprints, everything, camera, 1);
  if (!std::isfinite(zoom)) return refused("no part of the picture fills a frame");
  return {.valid = true, .camera = zoomed(everything, zoom), .why = {}};
}

}  // namespace cps
