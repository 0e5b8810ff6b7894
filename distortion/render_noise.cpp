#include "distortion/render_noise.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cps {
namespace {

namespace algo = OIIO::ImageBufAlgo;

void check_halves(const MasterHalves& master, const WarpOptions& options) {
  const OIIO::ImageSpec &first = master.first.spec(), &second = master.second.spec();
  if (first.width != second.width || first.height != second.height || first.nchannels != second.nchannels ||
      first.format != second.format)
    throw std::runtime_error("warp: the master's halves differ in size, channels or pixel type");
  if (options.resampling != Resampling::footprint)
    throw std::runtime_error("warp: a master's halves can only be averaged: resampling = footprint");
}

}  // namespace

OIIO::ImageBuf mean(const MasterHalves& halves) {
  return algo::mul(algo::add(halves.first, halves.second), 0.5f);
}

OIIO::ImageBuf warp(const MasterHalves& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  check_halves(master, options);
  const OIIO::ImageBuf picture = warp(mean(master), master_camera, lens, output, options, summary);

  constexpr double grain = noise_grain_px * noise_grain_px;
  WarpOptions narrower = options;
  narrower.kernel_sigma_px = std::sqrt(options.kernel_sigma_px * options.kernel_sigma_px - grain / 12);
  narrower.require_resolution = false;  // asked of the picture already; weightless where it is lacking
  const OIIO::ImageBuf half_difference = algo::mul(algo::sub(master.first, master.second), 0.5f);
  const OIIO::ImageBuf noise = warp_weighted(
      half_difference, master_camera, lens, output, narrower,
      [](float source_area) { return std::sqrt(std::max(0.0f, float(grain) * source_area - 1)); });
  return algo::add(picture, noise);
}

}  // namespace cps
