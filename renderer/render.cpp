#include "renderer/render.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <stdexcept>

#include "numbers/wall_time.h"
#include "renderer/camera_path.h"

namespace cps {
namespace {

/// Sums over one pixel's samples.
struct PixelSum {
  Color sum = Color::Zero(), sum_of_squares = Color::Zero();

  void add(const Color& radiance) {
    sum += radiance;
    sum_of_squares += radiance.square();
  }
  Color mean(int count) const { return sum / static_cast<float>(count); }
  /// Of the mean, without bias; 0 for a single sample.
  Color variance_of_mean(int count) const {
    if (count < 2) return Color::Zero();
    const auto n = static_cast<float>(count);
    return ((sum_of_squares - sum.square() / n) / (n * (n - 1.0f))).max(0.0f);
  }
};

/// A picture's pixels while they are rendered.
struct Pixels {
  int width, height;
  float* mean;
  float* variance;  ///< null: not wanted

  bool contains(const TilePixel& at) const { return at.x < width && at.y < height; }
  void set(const TilePixel& at, const PixelSum& pixel, int count) const {
    const std::size_t offset = 3 * (static_cast<std::size_t>(at.y) * width + at.x);
    Eigen::Map<Color>(mean + offset) = pixel.mean(count);
    if (variance) Eigen::Map<Color>(variance + offset) = pixel.variance_of_mean(count);
  }
};

/// What every tile of a picture is rendered with.
struct TileRenderer {
  const RenderScene& scene;
  PathSource source;
  SampleRange range;  ///< of every pixel
  const RenderOptions& options;
  Pixels pixels;

  /// Renders a tile. Its samples, pixel after pixel, are traced in packets: all of one pixel, or of a few
  /// neighbours where a pixel has less than a packet. Returns the number of rays.
  std::uint64_t render(const Tile& tile) const {
    std::uint64_t rays = 0;
    const int count = Tile::pixels * range.count;
    PixelSum pixel;
    CameraPixel camera;
    for (int first = 0; first < count; first += packet_size) {
      Path paths[packet_size];
      for (int i = 0; i < packet_size && first + i < count; ++i) {
        const TilePixel at = tile_pixel(tile, (first + i) / range.count);
        if (!pixels.contains(at)) continue;
        const int sample = (first + i) % range.count;
        if (sample == 0) camera = camera_pixel(source.rays, at.x, at.y);
        paths[i] = camera_path(source, camera, at.x, at.y, range.first + sample);
      }
      trace_packet(scene, options, paths);
      for (int i = 0; i < packet_size && first + i < count; ++i) {
        rays += paths[i].rays;
        pixel.add(paths[i].radiance);
        if ((first + i) % range.count != range.count - 1) continue;
        const TilePixel at = tile_pixel(tile, (first + i) / range.count);
        if (pixels.contains(at)) pixels.set(at, pixel, range.count);
        pixel = {};
      }
    }
    return rays;
  }
};

}  // namespace

std::string RenderOptions::fault() const {
  if (samples < 1 || samples > 65536) return "samples: must lie in [1, 65536]";
  if (max_shaded_vertices < 1 || max_shaded_vertices > 1000)
    return "max_shaded_vertices: must lie in [1, 1000]";
  return {};
}

std::string RenderSummary::brief() const {
  const double count = static_cast<double>(samples);
  return fmt::format("{:.2f} s ({:.2f} CPU-s), {:.2f} M samples at {:.0f} ns, {:.2f} rays each", wall_s,
                     cpu_s, 1e-6 * count, samples > 0 ? 1e9 * cpu_s / count : 0.0,
                     samples > 0 ? static_cast<double>(rays) / count : 0.0);
}

OIIO::ImageBuf render(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                      RenderSummary* summary, OIIO::ImageBuf* variance) {
  return render_samples(scene, camera, options, {0, options.samples}, summary, variance);
}

OIIO::ImageBuf render_samples(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                              const SampleRange& range, RenderSummary* summary, OIIO::ImageBuf* variance) {
  if (const std::string fault = options.fault(); !fault.empty()) throw std::runtime_error(fault);
  if (range.first < 0 || range.count < 1 || range.count > options.samples - range.first)
    throw std::runtime_error("samples: the range must be a part of those the picture has");

  const auto begin = std::chrono::steady_clock::now();
  const int width = camera.pinhole.width, height = camera.pinhole.height;
  const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
  PathSource source = make_path_source(camera, options);
  OIIO::ImageBuf image(spec);
  if (variance) variance->reset(spec);
  const TileRenderer tiles{scene, std::move(source), range, options,
                           Pixels{width, height, static_cast<float*>(image.localpixels()),
                                  variance ? static_cast<float*>(variance->localpixels()) : nullptr}};
  std::atomic<std::uint64_t> rays = 0;
  const double cpu_s = for_each_tile(
      width, height, [&](const Tile& tile) { rays += tiles.render(tile); }, options.progress);
  if (summary) {
    summary->wall_s = seconds_since(begin);
    summary->cpu_s = cpu_s;
    summary->samples = static_cast<std::uint64_t>(width) * height * range.count;
    summary->rays = rays.load();
  }
  return image;
}

}  // namespace cps
