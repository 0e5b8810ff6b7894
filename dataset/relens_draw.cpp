#include "dataset/relens_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "dataset/labels/group_label.h"
#include "dataset/labels/label_check.h"
#include "distortion/crop/true_fov.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/view_fit.h"
#include "numbers/angles.h"
#include "sampler/lenses/lens_draw.h"

namespace cps {
namespace {

/// The widest camera of this size that sees nothing beyond `straight`, degrees.
double widest_base_deg(const Pinhole& straight, const ImageSize& size) {
  const double half_width = std::min(.5 * straight.width / straight.fx,
                                     .5 * straight.height / straight.fy * size.width / size.height);
  return degrees(2 * std::atan(half_width));
}

/// Empty when the pictures do not carry the lens.
std::optional<Label> label_of(const DrawnLens& lens, const Pinhole& straight, const RelensOptions& options) {
  constexpr double sigma_px = .5;
  const Pinhole& camera = lens.crop.camera;
  const double magnification = camera.fx / straight.fx * lens.crop.certificate.max_eigenvalue;
  if (magnification > largest_magnification({.oversampling = 1, .kernel_sigma_px = sigma_px})) return {};
  const ViewFit fit = fit_distorted_view(straight, {"", camera, lens.distortion}, sigma_px, 2);
  if (!fit.valid || fit.camera.fx > camera.fx) return {};
  const Eigen::AlignedBox2d frame = frame_on_plane(lens.base);
  const auto angles = true_fov(lens.distortion, camera, frame);
  if (!angles) return {};
  Label label;
  label.camera = camera;
  label.distortion = lens.distortion;
  label.fov_base_deg = degrees(hfov_rad(lens.base));
  label.fov_true_h_deg = degrees(angles->horizontal_rad);
  label.fov_true_v_deg = degrees(angles->vertical_rad);
  label.fov_true_d_deg = degrees(angles->diagonal_rad);
  label.zoom = lens.crop.zoom;
  label.certificate_min_eigenvalue = lens.crop.certificate.min_eigenvalue;
  label.limits = lens.limits;
  label.part = Part::test;
  label.seed = options.seed;
  label.generator = generator_name();
  label.certificate_max_roundtrip_px = check_label(label).worst_roundtrip_px;
  return label;
}

}  // namespace

bool RelensOptions::is_valid(std::string* why) const {
  if (lenses < 1 || lenses > 10000) {
    *why = "lenses: must lie in [1, 10000]";
    return false;
  }
  if (size != ImageSize{0, 0} && (size.width < 32 || size.height < 32)) {
    *why = "size: must be at least 32x32 pixels";
    return false;
  }
  if (!(narrowest > 0 && narrowest <= 1)) {
    *why = "narrowest: must lie in (0, 1]";
    return false;
  }
  *why = lens.fault();
  return why->empty();
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
      label = label_of(draw_lens(base, CropOrder::base_first, options.lens, substream(draw, 1)), straight,
                       options);
    }
    if (!label)
      throw std::runtime_error(fmt::format("camera {}: no lens found for {}x{}: ask for a smaller size",
                                           camera, size.width, size.height));
    label->rig_camera = camera;
    groups.push_back({fmt::format("{}/{}_lens{:04}", set, camera, number), *label});
  }
  return groups;
}

}  // namespace cps
