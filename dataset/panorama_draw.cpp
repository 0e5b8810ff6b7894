#include "dataset/panorama_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "dataset/labels/group_label.h"
#include "dataset/labels/model_label.h"
#include "distortion/models/warp/seen_hfov.h"
#include "distortion/models/warp/source_resolution.h"
#include "distortion/warp/master_camera.h"
#include "numbers/angles.h"
#include "sampler/lenses/lens_draw.h"
#include "sampler/lenses/model_prior.h"
#include "scenes/rig.h"

namespace cps {
namespace {

std::string interval_fault(const char* field, const Interval& interval, double lowest, double highest) {
  if (interval.low >= lowest && interval.low <= interval.high && interval.high <= highest) return "";
  return fmt::format("{}: must lie in {:g}..{:g} degrees, the smaller number first", field, lowest, highest);
}

/// The name without an ending like _4k.
std::string_view place_name(std::string_view name) {
  const std::size_t at = name.find_last_of('_');
  if (at == name.npos || at + 3 > name.size() || std::tolower(static_cast<unsigned char>(name.back())) != 'k')
    return name;
  const std::string_view digits = name.substr(at + 1, name.size() - at - 2);
  const bool is_number = std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c) != 0; });
  return is_number ? name.substr(0, at) : name;
}

/// A drawn lens with its camera and what belongs to the label of its family.
struct DrawnView {
  ModelCamera camera;
  std::optional<DrawnLens> brown_conrady;
};

bool draws_focal(const PanoramaSetOptions& options) {
  return options.focal_px.high > 0;
}

/// The lens of a family's prior, its focal length drawn, its principal point in the middle.
DrawnView view_of_drawn_focal(const PanoramaSetOptions& options, Stream stream) {
  constexpr double of_width_px = 299;
  const auto [width, height] = options.size;
  const Stream focals = make_stream(stream.key, "focal");
  const double focal =
      random_uniform(focals, 0, options.focal_px.low, options.focal_px.high) * width / of_width_px;
  const Pinhole pinhole{width, height, focal, focal, .5 * (width - 1), .5 * (height - 1)};
  return {{"", pinhole, draw_model_lens(options.family, stream)}, std::nullopt};
}

/// Nothing if the lens does not reach the H-FOV.
std::optional<DrawnView> draw_view(const PanoramaSetOptions& options, double hfov_rad, Stream stream) {
  const auto [width, height] = options.size;
  if (options.family == "brown_conrady") {
    const Pinhole wanted = pinhole_from_hfov(width, height, hfov_rad);
    const DrawnLens lens = draw_lens(wanted, CropOrder::label_first, options.lens, stream);
    return DrawnView{{"", lens.crop.camera, lens.distortion}, lens};
  }
  if (draws_focal(options)) return view_of_drawn_focal(options, stream);
  const auto camera = camera_from_seen_hfov(draw_model_lens(options.family, stream), width, height, hfov_rad);
  if (!camera) return std::nullopt;
  return DrawnView{*camera, std::nullopt};
}

/// Whether the lens is certified on its frame and the panorama fine enough for it. The margin covers what
/// lies between the points that are looked at.
bool panorama_suffices(const PanoramaSource& panorama, const ModelCamera& camera) {
  constexpr double sigma_px = .5, margin = 1.01;
  const ModelCertificate proof = certify_frame(camera, warpable);
  if (!proof.valid) return false;
  const double needed_px = margin / largest_magnification({.oversampling = 1, .kernel_sigma_px = sigma_px});
  return fewest_panorama_px({panorama.width, panorama.width / 2}, camera, proof.region) >= needed_px;
}

/// From a camera of the vehicle that looks straight ahead, at the panorama's middle.
Eigen::Isometry3d pose_of(const PanoramaView& view) {
  // A rig's yaw is to the left, a panorama's to the right.
  return vehicle_from_camera({.name = view.camera.name,
                              .position_m = Eigen::Vector3d::Zero(),
                              .yaw_deg = -degrees(view.yaw_rad),
                              .pitch_deg = degrees(view.pitch_rad),
                              .roll_deg = degrees(view.roll_rad)});
}

nlohmann::ordered_json label_of(const PanoramaView& view, const DrawnView& drawn,
                                const PanoramaSetOptions& options) {
  const auto completed = [&](auto label) {
    label.vehicle_from_camera = pose_of(view);
    label.part = view.part;
    label.seed = options.seed;
    return to_json(label);
  };
  if (!drawn.brown_conrady) return completed(model_label(view.camera));
  Label label = lens_label(*drawn.brown_conrady, options.lens.bounds);
  label.rig_camera = view.camera.name;
  return completed(label);
}

}  // namespace

std::string PanoramaSetOptions::fault() const {
  const bool is_brown_conrady = family == "brown_conrady";
  if (!is_brown_conrady && std::ranges::find(prior_families(), family) == prior_families().end()) {
    std::string known = "brown_conrady";
    for (const std::string_view name : prior_families()) known += ", " + std::string(name);
    return "lens_model: must be one of " + known;
  }
  for (const std::string& fault :
       {interval_fault("hfov", hfov_deg, 5, is_brown_conrady ? 150 : 195),
        interval_fault("pitch", pitch_deg, -90, 90), interval_fault("roll", roll_deg, -180, 180)})
    if (!fault.empty()) return fault;
  if (draws_focal(*this) && family != "unified_spherical")
    return "focal: needs the lens model unified_spherical";
  if ((draws_focal(*this) || focal_px.low != 0) &&
      !(focal_px.low >= 10 && focal_px.low <= focal_px.high && focal_px.high <= 10000))
    return "focal: must lie in 10..10000 pixels, the smaller number first";
  if (views < 1 || views > 10000) return "views: must lie in [1, 10000]";
  if (size.width < 32 || size.height < 32) return "size: must be at least 32x32 pixels";
  return lens.fault();
}

Part part_of_panorama(std::string_view name) {
  const Stream stream = substream(make_stream(0, "panorama part"), make_stream(0, place_name(name)).key);
  const double place = random_uniform(stream, 0);
  return place < .70 ? Part::train : place < .85 ? Part::val : Part::test;
}

std::vector<PanoramaView> draw_panorama_views(const PanoramaSource& panorama,
                                              const PanoramaSetOptions& options) {
  const Stream of_panorama =
      substream(make_stream(options.seed, "panorama views"), make_stream(0, panorama.name).key);
  constexpr int attempts = 1000;
  std::vector<PanoramaView> views;
  for (int number = 1; number <= options.views; ++number) {
    const Stream stream = substream(of_panorama, static_cast<std::uint64_t>(number));
    const auto uniform_rad = [&](int index, const Interval& degrees_in) {
      return radians(random_uniform(stream, index, degrees_in.low, degrees_in.high));
    };
    PanoramaView view{.folder = fmt::format("{}x{}_panoramas/{}_lens{:04}", options.size.width,
                                            options.size.height, panorama.name, number),
                      .camera = {},
                      .yaw_rad = uniform_rad(0, {-180, 180}),
                      .pitch_rad = uniform_rad(1, options.pitch_deg),
                      .roll_rad = uniform_rad(2, options.roll_deg),
                      .part = part_of_panorama(panorama.name),
                      .label = {}};
    std::optional<DrawnView> drawn;
    for (int attempt = 0; attempt < attempts && !drawn; ++attempt) {
      const Stream draw = substream(stream, attempt);
      const double hfov_rad = radians(random_uniform(draw, 0, options.hfov_deg.low, options.hfov_deg.high));
      drawn = draw_view(options, hfov_rad, substream(draw, 1));
      if (drawn && !panorama_suffices(panorama, drawn->camera)) drawn.reset();
    }
    if (!drawn) {
      const Interval& range = draws_focal(options) ? options.focal_px : options.hfov_deg;
      throw std::runtime_error(fmt::format(
          "no {} lens found for {}x{} and {} of {:g}..{:g} {} in {} pixels around: ask for a smaller "
          "size or other {}, or take finer panoramas",
          options.family, options.size.width, options.size.height,
          draws_focal(options) ? "focal lengths" : "H-FOVs", range.low, range.high,
          draws_focal(options) ? "pixels" : "degrees", panorama.width,
          draws_focal(options) ? "focal lengths" : "H-FOVs"));
    }
    view.camera = drawn->camera;
    view.camera.name = panorama.name;
    view.label = label_of(view, *drawn, options);
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace cps
