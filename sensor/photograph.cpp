#include "sensor/photograph.h"

#include <utility>

namespace cps {

Master master_from_halves(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second, const Pinhole& camera) {
  Master master{.camera = camera, .light = join_halves(first, second)};
  master.exposure = meter_exposure(master.light.picture);
  return master;
}

OIIO::ImageBuf photograph_light(OIIO::ImageBuf light, double exposure, const Sensor& sensor,
                                PixelFormat format) {
  if (format == PixelFormat::linear) return expose(light, exposure, sensor.settings);
  if (format == PixelFormat::gray && light.spec().nchannels > 1) light = luminance(light);
  return develop(light, exposure, sensor.settings, sensor.noise);
}

OIIO::ImageBuf photograph(const Master& master, const CroppedLens& lens, const Sensor& sensor,
                          PixelFormat format, const std::function<void()>& after_lens) {
  OIIO::ImageBuf light =
      warp(master.light, master.camera, lens.distortion, lens.camera, {.box = lens.certified});
  if (after_lens) after_lens();
  return photograph_light(std::move(light), master.exposure, sensor, format);
}

}  // namespace cps
