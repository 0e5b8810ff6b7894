#include "production/view_images.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <exception>
#include <vector>

#include "dataset/job/masters.h"
#include "dataset/pixels/image_file.h"
#include "dataset/pixels/master_file.h"
#include "distortion/warp/render_noise.h"
#include "files/files.h"
#include "numbers/cpu_time.h"
#include "sensor/develop.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// Adds the CPU time of this thread, while it lives, to a stage.
class StageClock {
 public:
  explicit StageClock(std::atomic<std::int64_t>& sum_ns) : sum_ns_(sum_ns) {}
  ~StageClock() { sum_ns_ += static_cast<std::int64_t>(1e9 * (cpu_s(CLOCK_THREAD_CPUTIME_ID) - begin_s_)); }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  std::atomic<std::int64_t>& sum_ns_;
  double begin_s_ = cpu_s(CLOCK_THREAD_CPUTIME_ID);
};

OIIO::ImageBuf seen_through(const PlannedGroup& group, const PlannedView& view, const NoisyMaster& master,
                            ImageTimes& times) {
  const StageClock clock(times.warp_ns);
  return warp(master, view.master, group.lens.distortion, group.lens.crop.camera,
              {.box = frame_on_plane(group.lens.base)});
}

ImageRecord make_image(const Plan& plan, const PlannedView& view, const PlannedGroup& group,
                       const NoisyMaster& master, double exposure, const fs::path& root, ImageTimes& times) {
  const Stream stream = substream(make_stream(view.seed, "sensor"), group.lens_number);
  ImageRecord record{.file = group.folder + "/" + image_name(plan, view),
                     .sensor = draw_sensor(plan.recipe.sensor, make_stream(stream.key, "settings")),
                     .sha256 = {},
                     .pixels_sha256 = {}};
  OIIO::ImageBuf image = seen_through(group, view, master, times);
  const ImageFormat format = plan.recipe.image_format;
  {
    const StageClock clock(times.develop_ns);
    if (format == ImageFormat::png_gray) image = luminance(image);
    image = format == ImageFormat::exr
                ? expose(image, exposure, record.sensor)
                : develop(image, exposure, record.sensor, make_stream(stream.key, "noise"));
  }
  std::string bytes;
  {
    const StageClock clock(times.encode_ns);
    bytes = encode_image(image, format, plan.recipe.jpeg_quality);
    record.bytes = bytes.size();
    record.sha256 = sha256(bytes);
    record.pixels_sha256 = stored_pixels_sha256(image, format, bytes);
  }
  const StageClock clock(times.write_ns);
  write_file(root / record.file, bytes);
  return record;
}

MasterRecord keep_master(const Plan& plan, const PlannedView& view, const NoisyMaster& master,
                         const fs::path& root, ImageTimes& times) {
  MasterRecord record{.file = master_file_name(plan, view), .bytes = 0, .sha256 = {}};
  std::string bytes;
  {
    const StageClock clock(times.encode_ns);
    bytes = encode_master(master);
    record.bytes = bytes.size();
    record.sha256 = sha256(bytes);
  }
  const StageClock clock(times.write_ns);
  write_file(root / record.file, bytes);
  return record;
}

}  // namespace

ViewRecord make_images(const Plan& plan, std::int64_t index, const RenderedHalves& halves,
                       const fs::path& root, ImageTimes& times) {
  const PlannedView& view = plan.views[index];
  NoisyMaster master;
  ViewRecord record{.view = index, .exposure = 1, .images = {}};
  {
    const StageClock clock(times.warp_ns);
    master = join_halves(halves.first, halves.second);
    record.exposure = meter_exposure(master.picture);
  }
  record.images.resize(view.groups.size());
  std::vector<std::exception_ptr> errors(view.groups.size());
  // An exception that left the loop would cut others short in the middle of an image, which would be written.
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, view.groups.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t g = range.begin(); g != range.end(); ++g) try {
            // An arena of its own: this thread alone does the image and steals nothing meanwhile, so that its
            // clock counts the image and nothing else.
            tbb::task_arena(1).execute([&] {
              record.images[g] =
                  make_image(plan, view, plan.groups[view.groups[g]], master, record.exposure, root, times);
            });
          } catch (...) {
            errors[g] = std::current_exception();
          }
      },
      tbb::simple_partitioner());
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
  if (plan.recipe.keep_masters) record.master = keep_master(plan, view, master, root, times);
  return record;
}

}  // namespace cps
