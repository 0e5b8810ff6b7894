#include "sensor/photograph.h"

namespace cps {

Master master_from_halves(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second, const Pinhole& camera) {
  Master master{.camera = camera, .light = join_halves(first, second)};
  master.exposure = meter_exposure(master.light.picture);
  return master;
}

OIIO::ImageBuf photograph(const Master& master, const CroppedLens& lens, const Sensor& sensor,
                          PixelFormat format, const std::function<void()>& after_lens) {
  OIIO::ImageBuf image =
      warp(master.light, master.camera, lens.distortion, lens.camera, {.box = lens.certified});
  if (after_lens) after_lens();
  if (format == PixelFormat::linear) return expose(image, master.exposure, sensor.settings);
  if (format == PixelFormat::gray && image.spec().nchannels > 1) image = luminance(image);
  return develop(image, master.exposure, sensor.settings, sensor.noise);
}

}  // namespace cps
