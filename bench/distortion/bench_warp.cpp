#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <opencv2/imgproc.hpp>

#include "distortion/crop/crop.h"
#include "distortion/inverse/inverse_map.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/render_noise.h"
#include "numbers/angles.h"
#include "random/counter_hash.h"

using namespace cps;

namespace {

/// A KITTI-like barrel at 1920 × 1080, its crop, and a 2× master of noise.
struct Scene {
  Pinhole base = pinhole_from_hfov(1920, 1080, radians(90));
  Distortion lens =
      rescaled({-0.372, 0.203, -0.071, 0.002, -0.001}, 1 / (0.5 * frame_on_plane(base).diagonal().norm()));
  WarpOptions options;
  Crop crop = border_free_crop(lens, base, {base.cx, base.cy});
  Pinhole camera = master_camera(base, options, 0.15);
  OIIO::ImageBuf master;

  explicit Scene(int channels)
      : master(OIIO::ImageSpec(camera.width, camera.height, channels, OIIO::TypeFloat)) {
    float* values = static_cast<float*>(master.localpixels());
    for (std::size_t i = 0; i < std::size_t(camera.width) * camera.height * channels; ++i)
      values[i] = float(random_uniform(make_stream(22, "noise"), i));
  }
  double pixels() const { return double(base.width) * base.height; }
};

void report_per_pixel(benchmark::State& state, const Scene& scene) {
  state.counters["per_pixel"] = benchmark::Counter(double(state.iterations()) * scene.pixels(),
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Warp on one thread, inverse map included.
void warp_footprints(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Scene scene(int(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(warp(scene.master, scene.camera, scene.lens, scene.crop.camera));
  report_per_pixel(state, scene);
}
BENCHMARK(warp_footprints)->Arg(1)->Arg(3)->Arg(4)->Unit(benchmark::kMillisecond);

/// The same with render noise made uniform, as `cps generate` does.
void warp_noisy_master(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Scene scene(3);
  const NoisyMaster master{scene.master, scene.master};
  for (auto _ : state) benchmark::DoNotOptimize(warp(master, scene.camera, scene.lens, scene.crop.camera));
  report_per_pixel(state, scene);
}
BENCHMARK(warp_noisy_master)->Unit(benchmark::kMillisecond);

/// The best way to the same picture with OpenCV, one thread: bicubic remap onto a 2× grid of the output, then
/// INTER_AREA. `with_map` adds the time to make the map, with this project's inverse, since OpenCV's does not
/// always converge.
void remap_cubic_area(benchmark::State& state, bool with_map) {
  cv::setNumThreads(1);
  Scene scene(int(state.range(0)));
  const cv::Mat master(scene.camera.height, scene.camera.width, CV_32FC(int(state.range(0))),
                       scene.master.localpixels());
  const Pinhole fine = oversampled(scene.crop.camera, 2);
  cv::Mat map_x(fine.height, fine.width, CV_32F), map_y(fine.height, fine.width, CV_32F);
  const auto tile = std::make_unique<InverseMapTile>();
  const auto make_map = [&] {
    constexpr int side = InverseMapTile::side;
    for (int y0 = 0; y0 < fine.height; y0 += side)
      for (int x0 = 0; x0 < fine.width; x0 += side) {
        const int width = std::min(side, fine.width - x0), height = std::min(side, fine.height - y0);
        invert_tile(scene.lens, frame_on_plane(scene.base), fine, {x0, y0, width, height}, *tile);
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x) {
            const int index = tile->index(x, y);
            map_x.at<float>(y0 + y, x0 + x) = float(scene.camera.fx * tile->x[index] + scene.camera.cx);
            map_y.at<float>(y0 + y, x0 + x) = float(scene.camera.fy * tile->y[index] + scene.camera.cy);
          }
      }
  };
  make_map();
  cv::Mat doubled, output;
  for (auto _ : state) {
    if (with_map) make_map();
    cv::remap(master, doubled, map_x, map_y, cv::INTER_CUBIC);
    cv::resize(doubled, output, {scene.base.width, scene.base.height}, 0, 0, cv::INTER_AREA);
    benchmark::DoNotOptimize(output.data);
  }
  report_per_pixel(state, scene);
}
BENCHMARK_CAPTURE(remap_cubic_area, without_map, false)
    ->Arg(1)
    ->Arg(3)
    ->Arg(4)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(remap_cubic_area, with_map, true)->Arg(3)->Unit(benchmark::kMillisecond);

}  // namespace
