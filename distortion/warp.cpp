#include "distortion/warp.h"

#include <OpenImageIO/imagebufalgo.h>
#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "distortion/footprints.h"
#include "distortion/frame_certificate.h"
#include "distortion/gather.h"
#include "distortion/point_sample.h"

namespace cps {
namespace {

/// Fills the tile's footprints for output pixels (x0, y0) … (x0+width−1, y0+height−1).
using Footprints = std::function<void(int x0, int y0, int width, int height, FootprintTile& tile)>;

/// One worker's buffers and tallies.
struct Worker {
  std::unique_ptr<FootprintTile> tile = std::make_unique<FootprintTile>();
  PlanarPatch patch;
  std::vector<PixelBounds> bounds = std::vector<PixelBounds>(FootprintTile::side * FootprintTile::side);
  std::vector<float> row;
  double worst_residual_px = 0, smallest_variance = std::numeric_limits<double>::infinity();
  std::int64_t uncovered = 0, fallbacks = 0;
};

/// One image, or a master's two halves.
using Sources = std::span<const OIIO::ImageBuf* const>;

/// Weighs a pixel of the first half against that of the second so that its noise has the variance
/// `wanted_gain`.
void weigh_halves(float* first, const float* second, int channels, float gain, float wanted_gain) {
  const float t = std::sqrt(std::max(0.0f, wanted_gain / gain - 1));
  for (int c = 0; c < channels; ++c) first[c] = 0.5f * ((first[c] + second[c]) + t * (first[c] - second[c]));
}

/// Gathers one tile of the output whose footprints are known.
void gather_tile(const Sources& sources, float wanted_noise_gain, int x0, int y0, Worker& worker,
                 OIIO::ImageBuf& output) {
  const OIIO::ImageBuf& source = *sources.front();
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
    read_patch(sources, all.x0, all.y0, all.x1 - all.x0 + 1, all.y1 - all.y0 + 1, worker.patch);

  const OIIO::ImageSpec& spec = output.spec();
  worker.row.resize(std::size_t(tile.width) * spec.nchannels);
  for (int row = 0; row < tile.height; ++row) {
    std::fill(worker.row.begin(), worker.row.end(), 0.0f);
    for (int column = 0; column < tile.width; ++column) {
      const int index = row * FootprintTile::side + column;
      if (worker.bounds[index].x0 < 0) continue;
      float pixel[8];
      gather(worker.patch, tile, index, worker.bounds[index], pixel);
      if (sources.size() == 2)
        weigh_halves(pixel, pixel + spec.nchannels, spec.nchannels, noise_gain(tile, index),
                     wanted_noise_gain);
      std::copy_n(pixel, spec.nchannels, &worker.row[std::size_t(column) * spec.nchannels]);
    }
    OIIO::convert_pixel_values(OIIO::TypeFloat, worker.row.data(), spec.format,
                               output.pixeladdr(x0, y0 + row), int(worker.row.size()));
  }
}

void check_source(const OIIO::ImageBuf& source, const Pinhole& camera, const Pinhole& output,
                  const WarpOptions& options) {
  std::string why;
  if (!options.is_valid(&why)) throw std::runtime_error("warp: " + why);
  const OIIO::ImageSpec& spec = source.spec();
  if (!source.initialized() || !source.localpixels())
    throw std::runtime_error("warp: the source's pixels are not in memory");
  if (spec.width != camera.width || spec.height != camera.height)
    throw std::runtime_error("warp: the source is " + std::to_string(spec.width) + " x " +
                             std::to_string(spec.height) + ", its camera " + std::to_string(camera.width) +
                             " x " + std::to_string(camera.height));
  if (spec.nchannels < 1 || spec.nchannels > 4)
    throw std::runtime_error("warp: the source needs 1 to 4 channels");
  if (output.width <= 0 || output.height <= 0 || !(output.fx > 0 && output.fy > 0))
    throw std::runtime_error("warp: the output needs a positive size and positive focal lengths");
}

/// The caller's box; else the part of the master that the output sees, or all of it if it sees more. The lens
/// need not be one-to-one beyond, where the pad only feeds footprints.
Eigen::AlignedBox2d box_to_invert_on(const Distortion& lens, const Eigen::AlignedBox2d& master,
                                     const Pinhole& output, const Eigen::AlignedBox2d& callers_box) {
  if (callers_box.isEmpty()) {
    const FrameCertificate seen = certify_frame(lens, output, master, warpable);
    if (seen.valid() && master.contains(seen.rectangle)) return seen.rectangle;
  }
  const Eigen::AlignedBox2d& box = callers_box.isEmpty() ? master : callers_box;
  if (const Certificate proof = certify(lens, box, warpable); !proof.valid)
    throw std::runtime_error("warp: " + proof.why);
  return box;
}

Footprints lens_footprints(const Pinhole& master_camera, const Distortion& lens, const Pinhole& output,
                           const WarpOptions& options) {
  const Eigen::AlignedBox2d box = box_to_invert_on(lens, frame_on_plane(master_camera), output, options.box);
  return [=](int x0, int y0, int width, int height, FootprintTile& tile) {
    distorting_footprints(lens, box, master_camera, output, options.kernel_sigma_px, x0, y0, width, height,
                          tile);
  };
}

OIIO::ImageBuf resample(const Sources& sources, const Pinhole& output, const WarpOptions& options,
                        const Footprints& footprints, WarpSummary* summary) {
  const auto start = std::chrono::steady_clock::now();
  const OIIO::ImageBuf& source = *sources.front();
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
            footprints(x0, y0, std::min(side, output.width - x0), std::min(side, output.height - y0),
                       *worker.tile);
            worker.worst_residual_px = std::max(worker.worst_residual_px, worker.tile->worst_residual_px);
            worker.fallbacks += worker.tile->fallbacks;
            if (options.resampling == Resampling::footprint)
              gather_tile(sources, float(options.noise_gain), x0, y0, worker, image);
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
    result.fallbacks += worker.fallbacks;
  }
  result.smallest_kernel_sigma_px = std::sqrt(std::max(0.0, smallest_variance));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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

}  // namespace

bool WarpOptions::is_valid(std::string* why) const {
  if (!(oversampling >= 1 && oversampling <= 8)) {
    *why = "oversampling: must lie between 1 and 8";
    return false;
  }
  if (!(kernel_sigma_px >= 0.3 && kernel_sigma_px <= 4)) {
    *why = "kernel_sigma_px: must lie between 0.3 and 4";
    return false;
  }
  if (!(noise_gain >= 0 && noise_gain <= 1)) {
    *why = "noise_gain: must lie between 0 and 1";
    return false;
  }
  return true;
}

int master_pad(const WarpOptions& options, double min_eigenvalue) {
  return int(std::ceil(kernel_support * options.kernel_sigma_px * options.oversampling / min_eigenvalue));
}

Pinhole master_camera(const Pinhole& base, const WarpOptions& options, double min_eigenvalue) {
  return oversampled(base, options.oversampling, master_pad(options, min_eigenvalue));
}

double largest_magnification(const WarpOptions& options) {
  // sigma² (oversampling / magnification)² − 1/12 ≥ narrowest².
  return options.oversampling * options.kernel_sigma_px /
         std::sqrt(1.0 / 12 + narrowest_sigma_px * narrowest_sigma_px);
}

std::string WarpSummary::brief() const {
  char line[160];
  std::snprintf(line, sizeof line,
                "warp %.3f s, worst inverse residual %.2g px, %lld uncovered, kernel >= %.2f source px",
                seconds, worst_residual_px, static_cast<long long>(uncovered_pixels),
                smallest_kernel_sigma_px);
  return line;
}

OIIO::ImageBuf warp(const OIIO::ImageBuf& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  check_source(master, master_camera, output, options);
  return resample(std::array{&master}, output, options, lens_footprints(master_camera, lens, output, options),
                  summary);
}

OIIO::ImageBuf warp(const MasterHalves& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  check_source(master.first, master_camera, output, options);
  check_source(master.second, master_camera, output, options);
  if (master.first.spec().nchannels != master.second.spec().nchannels ||
      master.first.spec().format != master.second.spec().format)
    throw std::runtime_error("warp: the master's halves differ in channels or pixel type");
  if (options.resampling != Resampling::footprint)
    throw std::runtime_error("warp: a master's halves can only be averaged: resampling = footprint");
  return resample(std::array{&master.first, &master.second}, output, options,
                  lens_footprints(master_camera, lens, output, options), summary);
}

OIIO::ImageBuf mean(const MasterHalves& halves) {
  return OIIO::ImageBufAlgo::mul(OIIO::ImageBufAlgo::add(halves.first, halves.second), 0.5f);
}

OIIO::ImageBuf unwarp(const OIIO::ImageBuf& source, const Pinhole& camera, const Distortion& lens,
                      const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  check_source(source, camera, output, options);
  const FrameCertificate proof = certify_frame(lens, camera, warpable);
  if (!proof.certificate.valid) throw std::runtime_error("unwarp: " + proof.why);
  const Footprints footprints = [&](int x0, int y0, int width, int height, FootprintTile& tile) {
    undistorting_footprints(lens, proof.rectangle, camera, output, options.kernel_sigma_px, x0, y0, width,
                            height, tile);
  };
  return resample(std::array{&source}, output, options, footprints, summary);
}

}  // namespace cps
