#include "distortion/models/warp/seen_hfov.h"

#include <cmath>

#include "distortion/models/warp/model_view.h"

namespace cps {
namespace {

ModelCamera centred_camera(const LensModel& lens, int width, int height, double focal) {
  return {.name = {},
          .pinhole = {.width = width,
                      .height = height,
                      .fx = focal,
                      .fy = focal,
                      .cx = 0.5 * (width - 1),
                      .cy = 0.5 * (height - 1)},
          .lens = lens};
}

}  // namespace

std::optional<double> seen_hfov_rad(const ModelCamera& camera, const RayRegion& region) {
  // The principal point's row alone: corners that see nothing leave the row's angle as it is.
  ModelCamera row = camera;
  row.pinhole.height = 1;
  row.pinhole.cy = 0;
  const std::optional<TrueFov> angles = seen_fov(row, region);
  if (!angles) return std::nullopt;
  return angles->horizontal_rad;
}

std::optional<ModelCamera> camera_from_seen_hfov(const LensModel& lens, int width, int height,
                                                 double hfov_rad) {
  const RayRegion region = certify_region(lens).region;
  if (!(region.max_angle_rad > 0 && hfov_rad > 0)) return std::nullopt;
  const auto camera = [&](double half_extent) {
    return centred_camera(lens, width, height, 0.5 * width / half_extent);
  };
  // The angle grows with the half extent of the normalised image; beyond the region there is none.
  const auto reaches = [&](double half_extent) {
    const std::optional<double> seen = seen_hfov_rad(camera(half_extent), region);
    return !seen || *seen >= hfov_rad;
  };
  double low = 0, high = 1e-3;
  constexpr int most_doublings = 64;
  for (int i = 0; i < most_doublings && !reaches(high); ++i) low = high, high *= 2;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (reaches(middle) ? high : low) = middle;
  }
  if (!(low > 0)) return std::nullopt;
  const ModelCamera found = camera(low);
  const std::optional<double> seen = seen_hfov_rad(found, region);
  constexpr double tolerance_rad = 1e-9;
  if (!seen || std::abs(*seen - hfov_rad) > tolerance_rad) return std::nullopt;
  return found;
}

}  // namespace cps
