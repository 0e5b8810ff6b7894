#pragma once

#include <functional>

#include "distortion/crop/cropped_lens.h"
#include "distortion/warp/render_noise.h"
#include "sensor/develop.h"

/// The one way to an image's pixels: from a master through lens and sensor, or from light through the sensor.
namespace cps {

/// What every lens sees of a view: its undistorted, linear, oversampled render and the exposure metered on
/// it.
struct Master {
  Pinhole camera;       ///< of the render: oversampled and padded, see master_camera()
  NoisyMaster light;    ///< float channels: three, or one of luminance
  double exposure = 1;  ///< factor from radiance to share of white, see meter_exposure()
};

/// The master of a view that was rendered in two halves. Throws as join_halves() does.
Master master_from_halves(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second, const Pinhole& camera);

/// The image that a sensor makes of the light on it: exposure, noise, format. `light`: linear, three float
/// channels, or one of luminance where the format is gray. Noise is a pure function of (sensor.noise, pixel,
/// channel).
OIIO::ImageBuf photograph_light(OIIO::ImageBuf light, double exposure, const Sensor& sensor,
                                PixelFormat format);

/// The image of a master through a lens and a sensor: warp, then photograph_light(). `after_lens` is called
/// between lens and sensor, on the same thread, for callers that time both. Throws as warp() does.
OIIO::ImageBuf photograph(const Master& master, const CroppedLens& lens, const Sensor& sensor,
                          PixelFormat format, const std::function<void()>& after_lens = {});

}  // namespace cps
