#include "apps/rerender.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/condition_scene.h"
#include "apps/progress.h"
#include "dataset/files.h"
#include "dataset/frames.h"
#include "dataset/image_file.h"
#include "dataset/label.h"
#include "sensor/develop.h"

namespace cps {
namespace {

struct DrawnImage {
  std::int64_t view;
  int group;
};

/// Any image with equal chance, none twice, in the plan's order.
std::vector<DrawnImage> draw_images(const Plan& plan, const RerenderOptions& options) {
  std::vector<DrawnImage> images;
  for (std::size_t v = 0; v < plan.views.size(); ++v)
    for (int g : plan.views[v].groups) images.push_back({static_cast<std::int64_t>(v), g});
  const auto wanted = std::min<std::size_t>(options.images, images.size());
  const Stream stream = make_stream(options.seed, "rerender");
  for (std::size_t i = 0; i < wanted; ++i)
    std::swap(images[i], images[i + random_below(stream, i, images.size() - i)]);
  images.resize(wanted);
  std::sort(images.begin(), images.end(), [](const DrawnImage& a, const DrawnImage& b) {
    return std::pair(a.view, a.group) < std::pair(b.view, b.group);
  });
  return images;
}

float srgb_encoded(float linear) {
  const float clipped = std::clamp(linear, 0.0f, 1.0f);
  return clipped <= 0.0031308f ? 12.92f * clipped : 1.055f * std::pow(clipped, 1 / 2.4f) - 0.055f;
}

/// Brightness as the eye has it, from 0 to 1: of stored pixels, or of linear ones after exposure.
OIIO::ImageBuf brightness(const OIIO::ImageBuf& image, bool is_linear) {
  const int channels = image.spec().nchannels;
  OIIO::ImageBuf values;
  values.copy(image, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf result(OIIO::ImageSpec(image.spec().width, image.spec().height, 1, OIIO::TypeDesc::FLOAT));
  const auto* from = static_cast<const float*>(values.localpixels());
  auto* to = static_cast<float*>(result.localpixels());
  for (std::size_t i = 0; i < image.spec().image_pixels(); ++i) {
    const float* p = from + i * channels;
    float rgb[3] = {p[0], channels < 3 ? p[0] : p[1], channels < 3 ? p[0] : p[2]};
    if (is_linear)
      for (float& value : rgb) value = srgb_encoded(value);
    to[i] = 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
  }
  return result;
}

Camera camera_of(const PlannedView& view, const Label& label) {
  return {.world_from_camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera),
          .pinhole = label.camera,
          .lens = label.distortion};
}

OIIO::ImageBuf render_again(const Plan& plan, const PlannedView& view, const Label& label, double factor,
                            RenderScene& scene, const RerenderOptions& options) {
  put_car(scene, world_from_vehicle(view.place));
  OIIO::ImageBuf image = render(scene, camera_of(view, label),
                                {.samples = options.samples,
                                 .max_shaded_vertices = plan.recipe.max_shaded_vertices,
                                 .seed = make_stream(view.seed, "again").key,
                                 .filter = PixelFilter::gaussian});
  image = expose(image, factor, {});
  return plan.recipe.image_format == ImageFormat::png_gray ? luminance(image) : image;
}

std::string fault_of(const Registration& found, const RerenderOptions& options) {
  const double shift = std::hypot(found.shift_x_px, found.shift_y_px);
  if (shift - 3 * found.shift_noise_px > options.most_shift_px)
    return fmt::format("lies {:.2f} px off what its label says", shift);
  if (found.block_rms_px > options.most_block_rms_px)
    return fmt::format("its parts lie {:.2f} px (rms) off what its label says", found.block_rms_px);
  return "";
}

/// Exposure and bias of an image, by its line in frames.csv.
double exposure_of(const std::filesystem::path& root, const std::filesystem::path& file) {
  for (const FrameRow& row : read_frames_csv(root / file.parent_path() / "frames.csv"))
    if (row.file == file.filename().string()) return row.exposure * std::exp2(row.exposure_bias_ev);
  throw std::runtime_error((root / file).string() + ": is not in frames.csv");
}

}  // namespace

std::vector<RerenderedImage> rerender(const std::filesystem::path& root, const Plan& plan,
                                      const RerenderOptions& options) {
  const std::vector<DrawnImage> drawn = draw_images(plan, options);
  std::vector<RerenderedImage> images;
  ConditionScene loaded;
  Progress progress("images", 0, static_cast<std::int64_t>(drawn.size()));
  for (const DrawnImage& image : drawn) {
    const PlannedView& view = plan.views[image.view];
    const std::string file = plan.groups[image.group].folder + "/" + image_name(plan, view);
    const std::filesystem::path calibration = root / plan.groups[image.group].folder / "calibration.json";
    const Label label = label_from_json(read_json(calibration), calibration.string());
    const bool is_linear = plan.recipe.image_format == ImageFormat::exr;
    const OIIO::ImageBuf stored = brightness(read_pixels(root / file), is_linear);
    const OIIO::ImageBuf again = brightness(
        render_again(plan, view, label, exposure_of(root, file), loaded.of(plan, view), options), true);
    RerenderedImage result{.file = file, .registration = register_pictures(again, stored), .fault = {}};
    result.fault = fault_of(result.registration, options);
    images.push_back(result);
    progress.advance(1, file);
  }
  progress.finish();
  return images;
}

void write_report(const std::filesystem::path& root, const RerenderOptions& options,
                  const std::vector<RerenderedImage>& images) {
  nlohmann::ordered_json list = nlohmann::json::array();
  for (const RerenderedImage& image : images) {
    const Registration& found = image.registration;
    list.push_back({{"file", image.file},
                    {"shift_px", {found.shift_x_px, found.shift_y_px}},
                    {"shift_noise_px", found.shift_noise_px},
                    {"blocks", found.blocks},
                    {"block_rms_px", found.block_rms_px},
                    {"worst_block_px", found.worst_block_px},
                    {"psnr_db", found.psnr_db},
                    {"fault", image.fault}});
  }
  write_json(root / ".cps" / "rerender.json", {{"samples", options.samples},
                                               {"most_shift_px", options.most_shift_px},
                                               {"most_block_rms_px", options.most_block_rms_px},
                                               {"images", list}});
}

}  // namespace cps
