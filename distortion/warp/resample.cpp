#include "distortion/warp/resample.h"

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "distortion/warp/gather.h"
#include "distortion/warp/point_sample.h"

namespace cps {
namespace {

/// One worker thread's buffers and tallies.
struct Worker {
  std::unique_ptr<FootprintTile> tile = std::make_unique<FootprintTile>();
  PlanarPatch patch;
  std::vector<PixelBounds> bounds = std::vector<PixelBounds>(FootprintTile::side * FootprintTile::side);
  std::vector<float> row;
  double worst_residual_px = 0, smallest_variance = std::numeric_limits<double>::infinity();
  std::int64_t uncovered = 0;
};

/// Gathers the tile of the output at (x0, y0) through the footprints in `worker.tile`.
void gather_tile(const OIIO::ImageBuf& source, int x0, int y0, Worker& worker, OIIO::ImageBuf& output) {
  const FootprintTile& tile = *worker.tile;
  constexpr PixelBounds uncovered{-1, -1, -1, -1};
  PixelBounds all{source.spec().width, source.spec().height, -1, -1};
  for (int row = 0; row < tile.height; ++row)
    for (int column = 0; column < tile.width; ++column) {
      const int index = row * FootprintTile::side + column;
      PixelBounds& bounds = worker.bounds[index];
      if (!is_footprint_inside(tile, index, source.spec().width, source.spec().height)) {
        bounds = uncovered;
        ++worker.uncovered;
        continue;
      }
      bounds = pixel_bounds(tile, index);
      worker.smallest_variance = std::min(worker.smallest_variance, double(tile.smaller_variance[index]));
      all = {std::min(all.x0, bounds.x0), std::min(all.y0, bounds.y0), std::max(all.x1, bounds.x1),
             std::max(all.y1, bounds.y1)};
    }
  if (all.x1 >= all.x0)
    read_patch(source, {all.x0, all.y0, all.x1 - all.x0 + 1, all.y1 - all.y0 + 1}, worker.patch);

  const OIIO::ImageSpec& spec = output.spec();
  worker.row.resize(std::size_t(tile.width) * spec.nchannels);
  for (int row = 0; row < tile.height; ++row) {
    std::fill(worker.row.begin(), worker.row.end(), 0.0f);
    for (int column = 0; column < tile.width; ++column) {
      const int index = row * FootprintTile::side + column;
      if (worker.bounds[index].x0 < 0) continue;
      float* pixel = &worker.row[std::size_t(column) * spec.nchannels];
      gather(worker.patch, tile, index, worker.bounds[index], pixel);
      if (!tile.weighted) continue;
      for (int channel = 0; channel < spec.nchannels; ++channel) pixel[channel] *= tile.weight[index];
    }
    OIIO::convert_pixel_values(OIIO::TypeFloat, worker.row.data(), spec.format,
                               output.pixeladdr(x0, y0 + row), int(worker.row.size()));
  }
}

}  // namespace

OIIO::ImageBuf resample(const OIIO::ImageBuf& source, const Pinhole& output, const WarpOptions& options,
                        const Footprints& footprints, WarpSummary* summary) {
  OIIO::ImageSpec spec(output.width, output.height, source.spec().nchannels, source.spec().format);
  spec.channelnames = source.spec().channelnames;
  OIIO::ImageBuf image(spec);

  tbb::enumerable_thread_specific<Worker> workers;
  constexpr int side = FootprintTile::side;
  const tbb::blocked_range2d<int> tiles(0, (output.height + side - 1) / side, 1, 0,
                                        (output.width + side - 1) / side, 1);
  tbb::parallel_for(
      tiles,
      [&](const tbb::blocked_range2d<int>& range) {
        Worker& worker = workers.local();
        for (int row = range.rows().begin(); row < range.rows().end(); ++row)
          for (int column = range.cols().begin(); column < range.cols().end(); ++column) {
            const int x0 = column * side, y0 = row * side;
            footprints({x0, y0, std::min(side, output.width - x0), std::min(side, output.height - y0)},
                       *worker.tile);
            worker.worst_residual_px = std::max(worker.worst_residual_px, worker.tile->worst_residual_px);
            if (options.resampling == Resampling::footprint)
              gather_tile(source, x0, y0, worker, image);
            else
              worker.uncovered += sample_tile(source, *worker.tile, options.resampling, x0, y0, image);
          }
      },
      tbb::simple_partitioner());

  WarpSummary result;
  double smallest_variance = std::numeric_limits<double>::infinity();
  for (const Worker& worker : workers) {
    result.worst_residual_px = std::max(result.worst_residual_px, worker.worst_residual_px);
    smallest_variance = std::min(smallest_variance, worker.smallest_variance);
    result.uncovered_pixels += worker.uncovered;
  }
  result.smallest_kernel_sigma_px = std::sqrt(std::max(0.0, smallest_variance));
  if (summary) *summary = result;

  if (options.require_coverage && result.uncovered_pixels > 0)
    throw std::runtime_error("warp: " + std::to_string(result.uncovered_pixels) +
                             " pixels see beyond the source: pad the master, or crop further");
  if (options.require_resolution && result.smallest_kernel_sigma_px < narrowest_sigma_px)
    throw std::runtime_error("warp: the image is magnified beyond what its source carries (kernel of " +
                             std::to_string(result.smallest_kernel_sigma_px) +
                             " source pixels): oversample more");
  return image;
}

}  // namespace cps
