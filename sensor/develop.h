#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstdint>
#include <string>

#include "random/counter_hash.h"

/// What the sensor does after the lens: exposure, noise, response curve, 8 bit. It comes after the warp, so
/// that noise and quantisation do not depend on the lens.
namespace cps {

/// The ranges from which each image's sensor is drawn, uniformly; the full well log-uniformly.
struct SensorOptions {
  double exposure_bias_min_ev = -0.5, exposure_bias_max_ev = 0.5;  ///< around the metered exposure
  double full_well_min_e = 2000, full_well_max_e = 12000;          ///< electrons at white: fewer, noisier
  double read_noise_min_e = 2, read_noise_max_e = 8;               ///< rms electrons
  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// One image's sensor.
struct SensorSettings {
  double exposure_bias_ev = 0;
  double full_well_e = 6000;
  double read_noise_e = 4;
};

/// The settings of one image: a pure function of `stream`.
SensorSettings draw_sensor(const SensorOptions& options, Stream stream);

/// The factor that brings a view's mean luminance to 18 % of white, metered on the middle half (in width and
/// height) of the linear master: it is the same for every lens. A pixel counts at most eight times the
/// median, so that the sun does not set the exposure. A black image gives 1. `linear_master` has three float
/// channels.
double meter_exposure(const OIIO::ImageBuf& linear_master);

/// Rec. 709 luminance of three linear float channels: what a sensor without colours sees.
OIIO::ImageBuf luminance(const OIIO::ImageBuf& linear);

/// The factor from radiance to share of white, `exposure`·2^bias.
double exposure_factor(double exposure, const SensorSettings& settings);

/// Linear radiance → share of white, without noise or clipping. `linear` has float channels.
OIIO::ImageBuf expose(const OIIO::ImageBuf& linear, double exposure, const SensorSettings& settings);

/// Linear radiance → 8-bit sRGB (IEC 61966-2-1): scaled by `exposure`·2^bias, shot and read noise as a normal
/// of variance (signal + read²) electrons per channel and pixel, clipped at white, encoded, rounded. Noise is
/// a pure function of (noise, pixel, channel). `linear` has float channels.
OIIO::ImageBuf develop(const OIIO::ImageBuf& linear, double exposure, const SensorSettings& settings,
                       Stream noise);

}  // namespace cps
