#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <filesystem>

#include "numbers/angles.h"
#include "renderer/camera_path.h"
#include "renderer/paths/render_scene.h"
#include "renderer/paths/surface.h"
#include "scenes/city/city.h"
#include "scenes/gltf_import.h"
#include "scenes/routes.h"

using namespace cps;

namespace {

/// A procedural city and a car's camera in one of its streets.
struct City {
  Scene scene;
  std::shared_ptr<const RenderScene> ready;

  City() {
    const auto file = std::filesystem::temp_directory_path() / "cps_bench_city.glb";
    write_city({.seed = 7, .extent_m = 300}, file);
    scene = import_gltf(file);
    std::filesystem::remove(file);
    ready = build_render_scene(scene, {});
  }

  Camera camera(double hfov_deg) const {
    const Place place = place_on_lane(scene.lanes.front(), 0.3 * length_m(scene.lanes.front()), 0, 0);
    return {.world_from_camera = world_from_vehicle(place) * vehicle_from_camera({}),
            .pinhole = pinhole_from_hfov(348, 128, radians(hfov_deg))};
  }
};

const City& city() {
  static const City made;
  return made;
}

void count(benchmark::State& state, const char* what, double each_iteration) {
  state.counters[what] =
      benchmark::Counter(double(state.iterations()) * each_iteration, benchmark::Counter::kIsRate);
}

/// The camera's rays at 8 samples a pixel, and their hits.
struct CameraRayset {
  std::vector<std::array<Path, packet_size>> packets;
  std::vector<std::array<Hit, packet_size>> hits;

  explicit CameraRayset(double hfov_deg) {
    const Camera camera = city().camera(hfov_deg);
    const PathSource source = make_path_source(camera, {.samples = packet_size});
    for (int y = 0; y < camera.pinhole.height; ++y)
      for (int x = 0; x < camera.pinhole.width; ++x) {
        const CameraPixel pixel = camera_pixel(source.rays, x, y);
        std::array<Path, packet_size> packet;
        for (int i = 0; i < packet_size; ++i) packet[i] = camera_path(source, pixel, x, y, i);
        packets.push_back(packet);
      }
    hits.resize(packets.size());
    for (std::size_t p = 0; p < packets.size(); ++p)
      for (int i = 0; i < packet_size; ++i) hits[p][i] = city().ready->bvh.intersect(packets[p][i].ray);
  }
};

void primary_rays_single(benchmark::State& state) {
  const CameraRayset rays(70);
  for (auto _ : state)
    for (const auto& packet : rays.packets)
      for (const Path& path : packet) benchmark::DoNotOptimize(city().ready->bvh.intersect(path.ray));
  count(state, "rays", double(packet_size * rays.packets.size()));
}
BENCHMARK(primary_rays_single)->Unit(benchmark::kMillisecond);

void primary_rays_in_packets(benchmark::State& state) {
  const CameraRayset rays(70);
  for (auto _ : state)
    for (const auto& packet : rays.packets) {
      Ray lanes[packet_size];
      bool active[packet_size];
      std::fill(std::begin(active), std::end(active), true);
      Hit hits[packet_size];
      for (int i = 0; i < packet_size; ++i) lanes[i] = packet[i].ray;
      city().ready->bvh.intersect_coherent(lanes, active, hits);
      benchmark::DoNotOptimize(hits);
    }
  count(state, "rays", double(packet_size * rays.packets.size()));
}
BENCHMARK(primary_rays_in_packets)->Unit(benchmark::kMillisecond);

void sun_rays_in_packets(benchmark::State& state) {
  const CameraRayset rays(70);
  std::uint64_t sent = 0;
  for (auto _ : state)
    for (std::size_t p = 0; p < rays.packets.size(); ++p) {
      Ray lanes[packet_size];
      bool active[packet_size];
      Color light[packet_size];
      for (int i = 0; i < packet_size; ++i) {
        active[i] = static_cast<bool>(rays.hits[p][i]);
        const Ray& seen = rays.packets[p][i].ray;
        lanes[i] = {seen.origin + (rays.hits[p][i].t - 1e-3f) * seen.direction, city().ready->sun.direction};
        sent += active[i];
      }
      city().ready->bvh.transmittance_coherent(lanes, active, light);
      benchmark::DoNotOptimize(light);
    }
  state.counters["rays"] = benchmark::Counter(double(sent), benchmark::Counter::kIsRate);
}
BENCHMARK(sun_rays_in_packets)->Unit(benchmark::kMillisecond);

/// Whole pictures, by one thread. Argument 0: H-FOV, degrees; argument 1: whether the rays go through a lens.
void paths(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  Camera camera = city().camera(double(state.range(0)));
  if (state.range(1))
    camera.lens = rescaled({-0.1, 0.02, 0, 0.001, -0.001},
                           1 / (0.5 * frame_on_plane(camera.pinhole).diagonal().norm()));
  RenderSummary summary;
  std::uint64_t rays = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(render(*city().ready, camera, {.samples = 16}, &summary));
    rays += summary.rays;
  }
  count(state, "paths", double(summary.samples));
  state.counters["rays"] = benchmark::Counter(double(rays), benchmark::Counter::kIsRate);
}
BENCHMARK(paths)->Args({60, 0})->Args({150, 0})->Args({60, 1})->Args({150, 1})->Unit(benchmark::kMillisecond);

}  // namespace
