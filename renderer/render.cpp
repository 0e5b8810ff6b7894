#include "renderer/render.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <time.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "renderer/flush_denormals.h"
#include "renderer/path.h"

namespace cps {
namespace {

constexpr int tile_size = 16;

double thread_cpu_s() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Rays of a camera.
struct Lens {
  Vec3 position;
  Eigen::Matrix3f world_from_camera;
  float fx, fy, cx, cy;
  float footprint;  ///< of a pixel that the texture lookups average over
};

Lens make_lens(const Camera& camera, int samples) {
  // Many samples a pixel average over it themselves: finer texture lookups then keep the picture crisp where
  // a surface is seen at a slant (as pbrt scales its differentials).
  const float footprint = std::max(0.125f, 1.0f / std::sqrt(static_cast<float>(samples)));
  return {camera.world_from_camera.translation().cast<float>(),
          camera.world_from_camera.linear().cast<float>(),
          static_cast<float>(camera.pinhole.fx),
          static_cast<float>(camera.pinhole.fy),
          static_cast<float>(camera.pinhole.cx),
          static_cast<float>(camera.pinhole.cy),
          footprint};
}

/// Sample `index` of pixel (x, y): a point of the pixel's square, uniformly.
Path camera_path(const Lens& lens, std::uint64_t seed, int x, int y, int index) {
  Path path;
  path.sampler = make_sampler(seed, x, y, static_cast<std::uint32_t>(index));
  const Eigen::Vector2f in_pixel = path.sampler.pair(pair_pixel);
  const Vec3 on_plane((static_cast<float>(x) - 0.5f + in_pixel.x() - lens.cx) / lens.fx,
                      (static_cast<float>(y) - 0.5f + in_pixel.y() - lens.cy) / lens.fy, 1.0f);
  const float cosine = 1.0f / on_plane.norm();
  path.ray.origin = lens.position;
  path.ray.direction = lens.world_from_camera * (on_plane * cosine);
  path.ray.id = static_cast<std::uint32_t>(mix64(path.sampler.pixel_key + static_cast<std::uint64_t>(index)));
  path.ray.from_viewer = true;
  // A pixel covers cos³/(fx fy) sr: the angle to its square root, smaller towards the corners.
  path.cone_spread = lens.footprint * cosine * std::sqrt(cosine / (lens.fx * lens.fy));
  path.alive = true;
  return path;
}

struct Offset {
  int x, y;
};

/// Along Morton's curve, so that eight pixels in a row are a block of 4×2.
Offset morton(int index) {
  Offset offset{0, 0};
  for (int bit = 0; bit < 8; ++bit) {
    offset.x |= (index >> (2 * bit) & 1) << bit;
    offset.y |= (index >> (2 * bit + 1) & 1) << bit;
  }
  return offset;
}

/// Means of a tile's pixels. Its samples, pixel after pixel, travel in packets: eight of one pixel, or of few
/// neighbours where a pixel has fewer.
std::uint64_t render_tile(const RenderScene& scene, const Lens& lens, const RenderOptions& options,
                          int tile_x, int tile_y, int width, int height, float* pixels) {
  std::uint64_t rays = 0;
  const int count = tile_size * tile_size * options.samples;
  Color sum = Color::Zero();
  for (int first = 0; first < count; first += packet_size) {
    Path paths[packet_size];
    for (int i = 0; i < packet_size && first + i < count; ++i) {
      const Offset offset = morton((first + i) / options.samples);
      const int x = tile_x + offset.x, y = tile_y + offset.y;
      if (x < width && y < height)
        paths[i] = camera_path(lens, options.seed, x, y, (first + i) % options.samples);
    }
    rays += trace_paths(scene, options.max_shaded_vertices, paths);
    for (int i = 0; i < packet_size && first + i < count; ++i) {
      sum += paths[i].radiance;
      if ((first + i) % options.samples != options.samples - 1) continue;
      const Offset offset = morton((first + i) / options.samples);
      const int x = tile_x + offset.x, y = tile_y + offset.y;
      if (x < width && y < height) {
        Eigen::Map<Color>(pixels + 3 * (static_cast<std::size_t>(y) * width + x)) =
            sum / static_cast<float>(options.samples);
      }
      sum = Color::Zero();
    }
  }
  return rays;
}

}  // namespace

bool RenderOptions::is_valid(std::string* why) const {
  const auto fail = [&](const char* what) {
    if (why) *why = what;
    return false;
  };
  if (samples < 1 || samples > 65536) return fail("samples: must lie in [1, 65536]");
  if (max_shaded_vertices < 1 || max_shaded_vertices > 1000)
    return fail("max_shaded_vertices: must lie in [1, 1000]");
  return true;
}

std::string RenderSummary::brief() const {
  char line[160];
  const double ns = samples > 0 ? 1e9 * cpu_s / static_cast<double>(samples) : 0.0;
  std::snprintf(line, sizeof line, "%.2f s (%.2f CPU-s), %.2f M samples at %.0f ns, %.2f rays each", wall_s,
                cpu_s, 1e-6 * static_cast<double>(samples), ns,
                samples > 0 ? static_cast<double>(rays) / static_cast<double>(samples) : 0.0);
  return line;
}

OIIO::ImageBuf render(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                      RenderSummary* summary) {
  std::string why;
  if (!options.is_valid(&why)) throw std::runtime_error(why);
  const int width = camera.pinhole.width, height = camera.pinhole.height;
  if (width < 1 || height < 1) throw std::runtime_error("camera: width and height must be at least 1");
  if (!(camera.pinhole.fx > 0 && camera.pinhole.fy > 0))
    throw std::runtime_error("camera: fx and fy must be positive");

  const auto begin = std::chrono::steady_clock::now();
  const Lens lens = make_lens(camera, options.samples);
  OIIO::ImageBuf image(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT));
  auto* pixels = static_cast<float*>(image.localpixels());
  const int across = (width + tile_size - 1) / tile_size, down = (height + tile_size - 1) / tile_size;
  std::atomic<std::uint64_t> rays = 0, cpu_ns = 0;
  tbb::parallel_for(
      tbb::blocked_range<int>(0, across * down),
      [&](const tbb::blocked_range<int>& tiles) {
        const FlushDenormals flush_denormals;
        const double cpu_begin = thread_cpu_s();
        for (int tile = tiles.begin(); tile != tiles.end(); ++tile) {
          rays += render_tile(scene, lens, options, tile % across * tile_size, tile / across * tile_size,
                              width, height, pixels);
        }
        cpu_ns += static_cast<std::uint64_t>(1e9 * (thread_cpu_s() - cpu_begin));
      },
      tbb::simple_partitioner());
  if (summary) {
    summary->wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    summary->cpu_s = 1e-9 * static_cast<double>(cpu_ns.load());
    summary->samples = static_cast<std::uint64_t>(width) * height * options.samples;
    summary->rays = rays.load();
  }
  return image;
}

}  // namespace cps
