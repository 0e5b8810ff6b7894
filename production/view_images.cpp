#include "production/view_images.h"

#include "dataset/job/masters.h"
#include "dataset/labels/valid_mask.h"
#include "dataset/pixels/image_file.h"
#include "dataset/pixels/master_file.h"
#include "files/files.h"
#include "numbers/cpu_time.h"
#include "production/each_image.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// The CPU time of this thread, stage by stage.
class StageClock {
 public:
  /// Adds the time since the last stage ended, or since the clock was made, to a stage's sum.
  void end_stage(std::atomic<std::int64_t>& sum_ns) {
    const double now_s = cpu_s(CLOCK_THREAD_CPUTIME_ID);
    sum_ns += static_cast<std::int64_t>(1e9 * (now_s - begin_s_));
    begin_s_ = now_s;
  }

 private:
  double begin_s_ = cpu_s(CLOCK_THREAD_CPUTIME_ID);
};

/// The clock began when the image did.
ImageRecord write_image(const ViewImages& wanted, const PlannedImage& planned, const OIIO::ImageBuf& image,
                        const Sensor& sensor, const fs::path& root, StageClock& clock, ImageTimes& times) {
  clock.end_stage(times.develop_ns);
  const std::string bytes = encode_image(image, wanted.format, wanted.jpeg_quality);
  ImageRecord record{.file = planned.file,
                     .sensor = sensor.settings,
                     .bytes = bytes.size(),
                     .sha256 = sha256(bytes),
                     .pixels_sha256 = stored_pixels_sha256(image, wanted.format, bytes)};
  clock.end_stage(times.encode_ns);
  write_file(root / record.file, bytes);
  clock.end_stage(times.write_ns);
  return record;
}

ImageRecord make_image(const ViewImages& wanted, const PlannedImage& planned, const Master& master,
                       const fs::path& root, ImageTimes& times) {
  StageClock clock;
  const Sensor sensor = sensor_of(wanted.sensor, planned.sensor);
  const OIIO::ImageBuf image = photograph(master, planned.lens, sensor, pixel_format_of(wanted.format),
                                          [&] { clock.end_stage(times.warp_ns); });
  return write_image(wanted, planned, image, sensor, root, clock, times);
}

/// Light that was traced through an image's own lens.
struct TracedLight {
  const OIIO::ImageBuf* light;
  std::optional<OIIO::ImageBuf> mask;  ///< of valid pixels; empty: all are
};

ImageRecord make_traced_image(const ViewImages& wanted, const PlannedImage& planned,
                              const TracedLight& traced, double exposure, const fs::path& root,
                              ImageTimes& times) {
  StageClock clock;
  const Sensor sensor = sensor_of(wanted.sensor, planned.sensor);
  OIIO::ImageBuf image = photograph_light(*traced.light, exposure, sensor, pixel_format_of(wanted.format));
  if (traced.mask) black_out(image, *traced.mask);
  return write_image(wanted, planned, image, sensor, root, clock, times);
}

/// The masks take as long as a warp's footprints do elsewhere, and count as that.
std::vector<TracedLight> traced_light(const ViewImages& wanted, const RenderedView& rendered,
                                      ImageTimes& times) {
  std::vector<TracedLight> all(wanted.images.size());
  for_each_image(all.size(), [&](std::size_t i) {
    StageClock clock;
    all[i] = {&rendered.traced[i], valid_mask(wanted.images[i].camera())};
    clock.end_stage(times.warp_ns);
  });
  return all;
}

MadeImages make_traced_images(const ViewImages& wanted, const RenderedView& rendered, const fs::path& root,
                              ImageTimes& times) {
  const std::vector<TracedLight> traced = traced_light(wanted, rendered, times);
  std::vector<MeteredImage> metered;
  for (const TracedLight& image : traced)
    metered.push_back({image.light, image.mask ? &*image.mask : nullptr});
  const double exposure = meter_exposure(metered);
  ViewRecord record{
      .view = wanted.view, .exposure = exposure, .images = std::vector<ImageRecord>(traced.size())};
  for_each_image(traced.size(), [&](std::size_t i) {
    record.images[i] = make_traced_image(wanted, wanted.images[i], traced[i], exposure, root, times);
  });
  return {std::move(record), frame_exposure(metered, exposure)};
}

MasterRecord keep_master(const std::string& file, const NoisyMaster& master, const fs::path& root,
                         ImageTimes& times) {
  StageClock clock;
  const std::string bytes = encode_master(master);
  MasterRecord record{.file = file, .bytes = bytes.size(), .sha256 = sha256(bytes)};
  clock.end_stage(times.encode_ns);
  write_file(root / record.file, bytes);
  clock.end_stage(times.write_ns);
  return record;
}

}  // namespace

ViewImages images_of(const Plan& plan, std::int64_t index) {
  const PlannedView& view = plan.views[index];
  ViewImages wanted{.view = index,
                    .master = view.master,
                    .images = {},
                    .sensor = plan.recipe.sensor,
                    .format = plan.recipe.image_format,
                    .jpeg_quality = plan.recipe.jpeg_quality};
  for (int g : view.groups) {
    const PlannedGroup& group = plan.groups[g];
    wanted.images.push_back({.file = group.folder + "/" + image_name(plan, view),
                             .lens = group.model ? CroppedLens{} : cropped(group.lens),
                             .sensor = substream(make_stream(view.seed, "sensor"), group.lens_number),
                             .model = group.model});
  }
  if (plan.recipe.keep_masters) wanted.master_file = master_file_name(plan, view);
  return wanted;
}

double rendered_pixels(const ViewImages& wanted) {
  const auto pixels = [](const Pinhole& camera) { return static_cast<double>(camera.width) * camera.height; };
  if (!wanted.are_traced()) return pixels(wanted.master);
  double sum = 0;
  for (const PlannedImage& image : wanted.images) sum += pixels(image.model->pinhole);
  return sum;
}

RenderedView render_view(const Recipe& recipe, const PlannedView& view, const ViewImages& wanted,
                         LitScene& lit, const TileProgress& progress) {
  if (!wanted.are_traced()) return render_halves(recipe, view, wanted.master, lit, progress);
  std::vector<ModelCamera> cameras;
  for (const PlannedImage& image : wanted.images) cameras.push_back(*image.model);
  return trace_images(recipe, view, cameras, lit, progress);
}

MadeImages make_images(const ViewImages& wanted, const RenderedView& rendered, const fs::path& root,
                       ImageTimes& times) {
  if (wanted.are_traced()) return make_traced_images(wanted, rendered, root, times);
  StageClock clock;
  const Master master = master_from_halves(rendered.first, rendered.second, wanted.master);
  clock.end_stage(times.warp_ns);
  const std::size_t count = wanted.images.size();
  ViewRecord record{
      .view = wanted.view, .exposure = master.exposure, .images = std::vector<ImageRecord>(count)};
  for_each_image(count, [&](std::size_t i) {
    record.images[i] = make_image(wanted, wanted.images[i], master, root, times);
  });
  if (!wanted.master_file.empty()) record.master = keep_master(wanted.master_file, master.light, root, times);
  return {std::move(record), frame_exposure(master)};
}

}  // namespace cps
