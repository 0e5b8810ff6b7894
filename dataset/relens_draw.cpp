#include "dataset/relens_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "dataset/labels/group_label.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/view_fit.h"
#include "numbers/angles.h"
#include "sampler/lenses/lens_draw.h"

namespace cps {
namespace {

/// H-FOV in degrees of the widest camera of this size that sees nothing beyond `straight`.
double widest_base_deg(const Pinhole& straight, const ImageSize& size) {
  const double half_width = std::min(.5 * straight.width / straight.fx,
                                     .5 * straight.height / straight.fy * size.width / size.height);
  return degrees(2 * std::atan(half_width));
}

/// Whether pictures taken at `straight` reach far enough for the lens and are fine enough for it.
bool picture_suffices(const DrawnLens& lens, const Pinhole& straight) {
  constexpr double sigma_px = .5;
  const Pinhole& camera = lens.crop.camera;
  const double magnification = camera.fx / straight.fx * lens.crop.certificate.max_eigenvalue;
  if (magnification > largest_magnification({.oversampling = 1, .kernel_sigma_px = sigma_px})) return false;
  const ViewFit fit = fit_distorted_view(straight, {"", camera, lens.distortion}, sigma_px, 2);
  return fit.valid && fit.camera.fx <= camera.fx;
}

}  // namespace

std::string RelensOptions::fault() const {
  if (lenses < 1 || lenses > 10000) return "lenses: must lie in [1, 10000]";
  if (size != ImageSize{0, 0} && (size.width < 32 || size.height < 32))
    return "size: must be at least 32x32 pixels";
  if (!(narrowest > 0 && narrowest <= 1)) return "narrowest: must lie in (0, 1]";
  return lens.fault();
}

std::vector<RelensGroup> draw_relens_groups(const Pinhole& straight, const std::string& camera,
                                            int first_lens, const RelensOptions& options) {
  const ImageSize size =
      options.size == ImageSize{0, 0} ? ImageSize{straight.width / 2, straight.height / 2} : options.size;
  const double widest_deg = widest_base_deg(straight, size);
  const std::string set =
      fmt::format("{}x{}_hfov{:03.0f}", size.width, size.height, degrees(hfov_rad(straight)));
  constexpr int attempts = 1000;
  std::vector<RelensGroup> groups;
  for (int number = first_lens; number < first_lens + options.lenses; ++number) {
    const Stream stream = substream(make_stream(options.seed, "relens"), number);
    std::optional<Label> label;
    for (int attempt = 0; attempt < attempts && !label; ++attempt) {
      const Stream draw = substream(stream, attempt);
      const double base_deg = random_uniform(draw, 0, options.narrowest * widest_deg, widest_deg);
      const Pinhole base = pinhole_from_hfov(size.width, size.height, radians(base_deg));
      const DrawnLens lens = draw_lens(base, CropOrder::base_first, options.lens, substream(draw, 1));
      if (picture_suffices(lens, straight)) label = lens_label(lens, options.lens.bounds);
    }
    if (!label)
      throw std::runtime_error(fmt::format("camera {}: no lens found for {}x{}: ask for a smaller size",
                                           camera, size.width, size.height));
    label->rig_camera = camera;
    label->part = Part::test;
    label->seed = options.seed;
    groups.push_back({fmt::format("{}/{}_lens{:04}", set, camera, number), *label});
  }
  return groups;
}

}  // namespace cps
