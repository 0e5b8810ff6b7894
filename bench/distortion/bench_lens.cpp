#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "distortion/certificate/certificate.h"
#include "distortion/certificate/displacement.h"
#include "distortion/crop/crop.h"
#include "distortion/crop/limits.h"
#include "distortion/inverse/inverse.h"
#include "distortion/inverse/inverse_map.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

namespace {

struct Case {
  Pinhole camera;
  Eigen::AlignedBox2d box;
  Distortion lens;
};

/// Lenses with the shape of real ones; only those that are certified, or all.
std::vector<Case> cases(bool certified_only) {
  const Stream stream = make_stream(20, "bench");
  std::vector<Case> all;
  for (int i = 0; all.size() < 1024; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Case c{camera, frame_on_plane(camera), random_lens(stream, i, camera)};
    if (!certified_only || is_certified(c.lens, c.box)) all.push_back(c);
  }
  return all;
}

void is_certified(benchmark::State& state) {
  const auto all = cases(false);
  std::size_t i = 0;
  for (auto _ : state) {
    const Case& c = all[i++ % all.size()];
    benchmark::DoNotOptimize(cps::is_certified(c.lens, c.box));
  }
}
BENCHMARK(is_certified);

void certify(benchmark::State& state) {
  const auto all = cases(true);
  std::size_t i = 0;
  for (auto _ : state) {
    const Case& c = all[i++ % all.size()];
    benchmark::DoNotOptimize(cps::certify(c.lens, c.box));
  }
}
BENCHMARK(certify);

void largest_displacement(benchmark::State& state) {
  const auto all = cases(true);
  std::size_t i = 0;
  for (auto _ : state) {
    const Case& c = all[i++ % all.size()];
    benchmark::DoNotOptimize(cps::largest_displacement(c.lens, c.box));
  }
}
BENCHMARK(largest_displacement);

void k1_limits(benchmark::State& state) {
  const auto all = cases(true);
  std::size_t i = 0;
  for (auto _ : state) {
    const Case& c = all[i++ % all.size()];
    benchmark::DoNotOptimize(coefficient_limits({}, Coefficient::k1, c.box, {}));
  }
}
BENCHMARK(k1_limits);

void border_free_zoom(benchmark::State& state) {
  const auto all = cases(true);
  std::size_t i = 0;
  for (auto _ : state) {
    const Case& c = all[i++ % all.size()];
    benchmark::DoNotOptimize(cps::border_free_zoom(c.lens, c.camera, {c.camera.cx + 5, c.camera.cy - 3}));
  }
}
BENCHMARK(border_free_zoom);

void undistort_point(benchmark::State& state) {
  const auto all = cases(true);
  std::vector<Eigen::Vector2d> targets;
  for (std::size_t i = 0; i < all.size(); ++i)
    targets.push_back(distort(all[i].lens, random_point(make_stream(21, "points"), i, all[i].box)));
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t k = i++ % all.size();
    benchmark::DoNotOptimize(undistort(all[k].lens, all[k].box, targets[k]));
  }
}
BENCHMARK(undistort_point);

/// Time per pixel of the map of a whole tile.
void inverse_map_pixel(benchmark::State& state) {
  const auto all = cases(true);
  const auto tile = std::make_unique<InverseMapTile>();
  constexpr int side = InverseMapTile::side;
  std::size_t i = 0;
  for (auto _ : state) {
    const Case& c = all[i++ % all.size()];
    invert_tile(c.lens, c.box, c.camera, {c.camera.width / 2 + 50, c.camera.height / 2 - 100, side, side},
                *tile);
    benchmark::DoNotOptimize(tile->x[5]);
  }
  state.counters["per_pixel"] = benchmark::Counter(double(state.iterations()) * side * side,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(inverse_map_pixel);

}  // namespace
