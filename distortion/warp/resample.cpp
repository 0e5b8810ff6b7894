#include "distortion/warp/resample.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "distortion/warp/gather.h"
#include "distortion/warp/pixel_bounds.h"
#include "distortion/warp/planar_patch.h"
#include "distortion/warp/point_sample.h"
#include "distortion/warp/tiles.h"
#include "distortion/warp/warp_checks.h"

namespace cps {
namespace {

constexpr int side = FootprintTile::side;

/// One worker thread's buffers and tallies.
struct Worker {
  std::unique_ptr<FootprintTile> tile = std::make_unique<FootprintTile>();
  std::vector<BoundsRow> bounds = std::vector<BoundsRow>(side);
  PlanarPatch patch;
  std::vector<float> pixels;

  PlanarPatch noise_patch;
  WeightedKernelRow noise_kernels;
  BoundsRow noise_bounds;

  double worst_residual_px = 0;
  alignas(32) std::array<float, side> smallest_variance;  ///< by column of the tile
  std::int64_t uncovered = 0;

  Worker() { smallest_variance.fill(std::numeric_limits<float>::infinity()); }
};

/// Takes note of the narrowest kernels of a row of the tile, among pixels with a footprint.
void note_variances(const FootprintTile& tile, int row, const BoundsRow& bounds,
                    std::array<float, side>& smallest) {
  const float* variance = &tile.smaller_variance[row * side];
  const int count = tile.width;
  for (int i = 0; i < count; ++i) {
    const bool smaller = (bounds.x0[i] >= 0) & (variance[i] < smallest[i]);
    smallest[i] = smaller ? variance[i] : smallest[i];
  }
}

/// Gathers a row of the tile into worker.pixels.
void gather_picture(int row, Worker& worker) {
  const FootprintTile& tile = *worker.tile;
  gather_row(worker.patch, {&tile.x[row * side], &tile.y[row * side], tile.kernels[row], worker.bounds[row]},
             tile.width, worker.pixels.data());
}

/// Gathers the noise of a row of the tile and adds it to worker.pixels.
void add_noise(const NoiseTarget& target, int row, Worker& worker) {
  const FootprintTile& tile = *worker.tile;
  make_noise_kernels(target, tile.kernels[row], tile.width, worker.noise_kernels);
  find_noise_bounds(tile, row, worker.noise_kernels, worker.bounds[row], worker.noise_bounds);
  add_gathered_row(
      worker.noise_patch,
      {&tile.x[row * side], &tile.y[row * side], worker.noise_kernels.kernels, worker.noise_bounds},
      worker.noise_kernels.weight.data(), tile.width, worker.pixels.data());
}

/// Gathers the tile of the output at (x0, y0) through the footprints in `worker.tile`.
void gather_tile(const OIIO::ImageBuf& source, const AddedNoise* noise, int x0, int y0, Worker& worker,
                 OIIO::ImageBuf& output) {
  const FootprintTile& tile = *worker.tile;
  for (int row = 0; row < tile.height; ++row) {
    worker.uncovered += find_bounds(tile, row, source.spec().width, source.spec().height, worker.bounds[row]);
    note_variances(tile, row, worker.bounds[row], worker.smallest_variance);
  }
  const TileRect seen = common_bounds({worker.bounds.data(), std::size_t(tile.height)}, tile.width);
  read_patch(source, seen, worker.patch);
  if (noise) read_patch(noise->image, seen, worker.noise_patch);

  const OIIO::ImageSpec& spec = output.spec();
  const std::size_t values = std::size_t(tile.width) * spec.nchannels;
  worker.pixels.resize(values);
  for (int row = 0; row < tile.height; ++row) {
    gather_picture(row, worker);
    if (noise) add_noise(noise->target, row, worker);
    OIIO::convert_pixel_values(OIIO::TypeFloat, worker.pixels.data(), spec.format,
                               output.pixeladdr(x0, y0 + row), int(values));
  }
}

}  // namespace

OIIO::ImageBuf resample(const OIIO::ImageBuf& source, const AddedNoise* noise, const Pinhole& output,
                        const WarpOptions& options, const Footprints& footprints, WarpSummary* summary) {
  OIIO::ImageSpec spec(output.width, output.height, source.spec().nchannels, source.spec().format);
  spec.channelnames = source.spec().channelnames;
  OIIO::ImageBuf image(spec, OIIO::InitializePixels::No);

  tbb::enumerable_thread_specific<Worker> workers;
  for_each_tile(output.width, output.height, [&](const TileRect& rect) {
    Worker& worker = workers.local();
    footprints(rect, *worker.tile);
    worker.worst_residual_px = std::max(worker.worst_residual_px, worker.tile->worst_residual_px);
    if (options.resampling == Resampling::footprint)
      gather_tile(source, noise, rect.x0, rect.y0, worker, image);
    else
      worker.uncovered += sample_tile(source, *worker.tile, options.resampling, rect.x0, rect.y0, image);
  });

  WarpSummary result;
  float smallest_variance = std::numeric_limits<float>::infinity();
  for (const Worker& worker : workers) {
    result.worst_residual_px = std::max(result.worst_residual_px, worker.worst_residual_px);
    smallest_variance = std::min(smallest_variance, *std::ranges::min_element(worker.smallest_variance));
    result.uncovered_pixels += worker.uncovered;
  }
  result.smallest_kernel_sigma_px = std::sqrt(std::max(0.0, double(smallest_variance)));
  if (summary) *summary = result;

  check_summary(result, options);
  return image;
}

}  // namespace cps
