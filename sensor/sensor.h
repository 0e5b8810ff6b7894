#pragma once

#include <string>

#include "random/counter_hash.h"

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

/// The sensor as it is for one image.
struct Sensor {
  SensorSettings settings;
  Stream noise;
};

/// Draws the settings and seeds the noise: a pure function of the arguments.
Sensor sensor_of(const SensorOptions& options, Stream stream);

/// What a sensor delivers.
enum class PixelFormat {
  rgb,    ///< 8-bit sRGB, each channel with its own noise
  gray,   ///< 8 bits of a sensor without colours: luminance, then noise, then the sRGB curve
  linear  ///< floats, 1 = white: exposed only, without noise, clipping or 8 bits
};

}  // namespace cps
