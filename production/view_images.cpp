#include "production/view_images.h"

#include "dataset/job/masters.h"
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

ImageRecord make_image(const ViewImages& wanted, const PlannedImage& planned, const Master& master,
                       const fs::path& root, ImageTimes& times) {
  StageClock clock;
  const Sensor sensor = sensor_of(wanted.sensor, planned.sensor);
  const OIIO::ImageBuf image = photograph(master, planned.lens, sensor, pixel_format_of(wanted.format),
                                          [&] { clock.end_stage(times.warp_ns); });
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
                             .lens = cropped(group.lens),
                             .sensor = substream(make_stream(view.seed, "sensor"), group.lens_number)});
  }
  if (plan.recipe.keep_masters) wanted.master_file = master_file_name(plan, view);
  return wanted;
}

MadeImages make_images(const ViewImages& wanted, const RenderedHalves& halves, const fs::path& root,
                       ImageTimes& times) {
  StageClock clock;
  const Master master = master_from_halves(halves.first, halves.second, wanted.master);
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
