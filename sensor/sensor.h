#pragma once

#include <string>

#include "random/counter_hash.h"

namespace cps {

/// The ranges from which each image's sensor is drawn, uniformly; the full well log-uniformly.
struct SensorOptions {
  double exposure_bias_min_ev = -0.5, exposure_bias_max_ev = 0.5;  ///< around the metered exposure
  double full_well_min_e = 2000, full_well_max_e = 12000;          ///< electrons at white: fewer, noisier
  double read_noise_min_e = 2, read_noise_max_e = 8;               ///< rms electrons
  /// Sensor pixels along each side of an image pixel, see binned(). The ranges above are of a sensor pixel.
  int binning = 1;
  double contrast_min = 1, contrast_max = 1;  ///< see SensorSettings::contrast
  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// One image's sensor. Electrons are those of an image pixel, which may stand for several of the sensor's.
struct SensorSettings {
  double exposure_bias_ev = 0;
  double full_well_e = 6000;
  double read_noise_e = 4;
  /// Exponent of the tone curve about middle gray (.18 of white), between noise and the sRGB curve: above 1,
  /// bright is brighter and dark darker, as cameras' own curves make pictures to look at.
  double contrast = 1;
};

/// What a sensor is to an image each of whose pixels is the mean of `binning` x `binning` sensor pixels, as
/// in a reduced picture: such a pixel counts binning² times the electrons at white, and as so many
/// independent reads add up, binning times the read noise. As a share of white, the variance is 1/binning² of
/// a sensor pixel's.
SensorSettings binned(SensorSettings sensor_pixel, int binning);

/// The settings of one image, of its own pixels: drawn for a sensor pixel, then binned(). A pure function of
/// the arguments.
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
