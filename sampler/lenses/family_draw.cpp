#include "sampler/lenses/family_draw.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "distortion/models/projection.h"
#include "distortion/models/warp/proved_camera.h"
#include "distortion/models/warp/seen_hfov.h"
#include "numbers/angles.h"
#include "sampler/lenses/model_prior.h"

namespace cps {
namespace {

constexpr int max_family_attempts = 1000;

/// Whether the region that is proved for the picture's frame holds the whole middle row.
bool shows_its_row(const ModelCamera& camera, double hfov_rad) {
  const RayRegion region = certify_frame(camera, one_to_one).region;
  if (is_empty(region)) return false;
  const std::optional<double> seen_rad = seen_hfov_rad(camera, region);
  return seen_rad && std::abs(*seen_rad - hfov_rad) <= 1e-9;
}

/// Whether pixels in the middle are not much coarser than the others of the row.
bool resolves_its_middle(const ModelCamera& camera, double hfov_rad) {
  constexpr double max_coarseness = 3;
  const double px_per_rad = camera.pinhole.fx * project(camera.lens, Eigen::Vector3d::UnitZ()).jacobian(0, 0);
  return max_coarseness * px_per_rad * hfov_rad >= camera.pinhole.width;
}

}  // namespace

ModelCamera draw_family_camera(std::string_view family, ImageSize size, double hfov_rad, Stream stream) {
  for (int attempt = 0; attempt < max_family_attempts; ++attempt) {
    const LensModel lens = draw_model_lens(family, substream(stream, attempt));
    const std::optional<ModelCamera> camera = camera_from_seen_hfov(lens, size.width, size.height, hfov_rad);
    if (camera && resolves_its_middle(*camera, hfov_rad) && shows_its_row(*camera, hfov_rad)) return *camera;
  }
  throw std::runtime_error(
      fmt::format("no {} lens found in {} attempts that shows {:g} degrees; choose a smaller hfov_deg",
                  family, max_family_attempts, degrees(hfov_rad)));
}

}  // namespace cps
