#include "production/rerender.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dataset/exchange/camera_json.h"
#include "dataset/job/frames.h"
#include "dataset/labels/valid_mask.h"
#include "dataset/pixels/image_file.h"
#include "files/files.h"
#include "numbers/srgb.h"
#include "production/condition_scene.h"
#include "production/view_render.h"
#include "random/shuffle.h"
#include "sensor/develop.h"

namespace cps {
namespace {

struct ChosenImage {
  std::int64_t view;
  int group;
};

/// Each image with equal chance, none twice, in the plan's order.
std::vector<ChosenImage> choose_images(const Plan& plan, const RerenderOptions& options) {
  std::vector<ChosenImage> images;
  for (std::size_t v = 0; v < plan.views.size(); ++v)
    for (int g : plan.views[v].groups) images.push_back({static_cast<std::int64_t>(v), g});
  const auto wanted = std::min<std::size_t>(options.images, images.size());
  draw_to_front(images, wanted, make_stream(options.seed, "rerender"));
  images.resize(wanted);
  std::sort(images.begin(), images.end(), [](const ChosenImage& a, const ChosenImage& b) {
    return std::pair(a.view, a.group) < std::pair(b.view, b.group);
  });
  return images;
}

/// sRGB-encoded brightness from 0 to 1: of stored pixels, or of linear ones after exposure.
OIIO::ImageBuf brightness(const OIIO::ImageBuf& image, bool is_linear) {
  OIIO::ImageBuf values;
  values.copy(image, OIIO::TypeDesc::FLOAT);
  auto* value = static_cast<float*>(values.localpixels());
  for (std::size_t i = 0; is_linear && i < values.spec().image_pixels() * values.spec().nchannels; ++i)
    value[i] = static_cast<float>(srgb_from_linear(std::clamp(value[i], 0.0f, 1.0f)));
  return values.spec().nchannels == 1 ? values : luminance(values);
}

/// Renders what the files say: `labelled` is the camera with its lens, `frame` where car and camera stand.
/// `view` gives the seed alone. Black where a lens of another family than Brown–Conrady shows nothing.
OIIO::ImageBuf render_again(const Plan& plan, const PlannedView& view, const ModelCamera& labelled,
                            const FrameRow& frame, RenderScene& scene, const RerenderOptions& options) {
  put_car(scene, world_from_vehicle(frame.vehicle));
  const Camera camera{
      .world_from_camera = world_from_camera(frame), .pinhole = labelled.pinhole, .lens = labelled.lens};
  OIIO::ImageBuf image = render(scene, camera,
                                {.samples = options.samples,
                                 .max_shaded_vertices = plan.recipe.max_shaded_vertices,
                                 .seed = make_stream(view.seed, "again").key,
                                 .filter = PixelFilter::gaussian});
  image = expose(image, frame.exposure, frame.sensor);
  if (!plan.recipe.is_brown_conrady())
    if (const std::optional<OIIO::ImageBuf> mask = valid_mask(labelled)) black_out(image, *mask);
  return plan.recipe.image_format == ImageFormat::png_gray ? luminance(image) : image;
}

std::string fault_of(const Registration& found, const RerenderOptions& options) {
  if (!(found.correlation >= options.min_correlation))
    return fmt::format("shows another view than its label and pose say (correlation {:.2f})",
                       found.correlation);
  const double shift = std::hypot(found.shift_x_px, found.shift_y_px);
  if (shift - 3 * found.shift_noise_px > options.max_shift_px)
    return fmt::format("lies {:.2f} px off what its label and pose say", shift);
  if (found.block_rms_px > options.max_block_rms_px)
    return fmt::format("its parts lie {:.2f} px (rms) off what its label and pose say", found.block_rms_px);
  return "";
}

FrameRow frame_of(const std::filesystem::path& root, const std::filesystem::path& file) {
  for (const FrameRow& row : read_frames_csv(root / file.parent_path() / "frames.csv"))
    if (row.file == file.filename().string()) return row;
  throw std::runtime_error((root / file).string() + ": is not in frames.csv");
}

}  // namespace

std::vector<RerenderedImage> rerender(const std::filesystem::path& root, const Plan& plan,
                                      const RerenderOptions& options, const Watch& watch) {
  const std::vector<ChosenImage> chosen = choose_images(plan, options);
  std::vector<RerenderedImage> images;
  ConditionScene loaded;
  for (const ChosenImage& image : chosen) {
    const PlannedView& view = plan.views[image.view];
    const std::string file = plan.groups[image.group].folder + "/" + image_name(plan, view);
    const std::string calibration = (root / plan.groups[image.group].folder / "calibration.json").string();
    const nlohmann::json json = read_json(calibration);
    const ModelCamera labelled = model_camera_from_json({json, calibration});
    const bool is_linear = plan.recipe.image_format == ImageFormat::exr;
    const OIIO::ImageBuf stored = brightness(read_pixels(root / file), is_linear);
    const OIIO::ImageBuf again = brightness(
        render_again(plan, view, labelled, frame_of(root, file), *loaded.of(plan, view).scene, options),
        true);
    RerenderedImage result{.file = file, .registration = register_pictures(again, stored), .fault = {}};
    result.fault = fault_of(result.registration, options);
    images.push_back(result);
    watch.advanced(1, file);
  }
  return images;
}

}  // namespace cps
