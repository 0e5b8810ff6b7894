#include "distortion/warp/render_noise.h"

#include <OpenImageIO/imagebufalgo.h>

#include <stdexcept>

namespace cps {

namespace algo = OIIO::ImageBufAlgo;

NoisyMaster join_halves(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second) {
  const OIIO::ImageSpec &a = first.spec(), &b = second.spec();
  if (a.width != b.width || a.height != b.height || a.nchannels != b.nchannels || a.format != b.format)
    throw std::runtime_error("the master's halves differ in size, channels or pixel type");
  NoisyMaster master{.picture = algo::add(first, second), .noise = algo::sub(first, second)};
  algo::mul(master.picture, master.picture, 0.5f);
  algo::mul(master.noise, master.noise, 0.5f);
  return master;
}

OIIO::ImageBuf warp(const NoisyMaster& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  if (options.resampling != Resampling::footprint)
    throw std::runtime_error("warp: a noisy master can only be averaged: resampling = footprint");
  if (master.picture.nchannels() != master.noise.nchannels())
    throw std::runtime_error("warp: the master's picture and noise differ in channels");
  return warp_with_noise(master.picture, &master.noise, master_camera, lens, output, options, summary);
}

}  // namespace cps
