#include "sensor/sensor.h"

#include <cmath>

namespace cps {
namespace {

bool is_range(double low, double high, double min, double max) {
  return std::isfinite(low) && std::isfinite(high) && min <= low && low <= high && high <= max;
}

}  // namespace

std::string SensorOptions::fault() const {
  if (!is_range(exposure_bias_min_ev, exposure_bias_max_ev, -10, 10))
    return "exposure_bias_min_ev ≤ exposure_bias_max_ev must lie in [-10, 10]";
  if (!is_range(full_well_min_e, full_well_max_e, 1, 1e7))
    return "full_well_min_e ≤ full_well_max_e must lie in [1, 1e7]";
  if (!is_range(read_noise_min_e, read_noise_max_e, 0, 1e4))
    return "read_noise_min_e ≤ read_noise_max_e must lie in [0, 1e4]";
  if (binning < 1 || binning > 16) return "sensor_binning: must lie in [1, 16]";
  if (!is_range(contrast_min, contrast_max, .25, 4))
    return "contrast_min ≤ contrast_max must lie in [0.25, 4]";
  return {};
}

SensorSettings binned(SensorSettings sensor_pixel, int binning) {
  sensor_pixel.full_well_e *= binning * binning;
  sensor_pixel.read_noise_e *= binning;
  return sensor_pixel;
}

SensorSettings draw_sensor(const SensorOptions& options, Stream stream) {
  // Log-uniform, because noise levels compare as ratios.
  const double full_well = std::exp(
      random_uniform(stream, 1, std::log(options.full_well_min_e), std::log(options.full_well_max_e)));
  const SensorSettings sensor_pixel{
      .exposure_bias_ev =
          random_uniform(stream, 0, options.exposure_bias_min_ev, options.exposure_bias_max_ev),
      .full_well_e = full_well,
      .read_noise_e = random_uniform(stream, 2, options.read_noise_min_e, options.read_noise_max_e),
      .contrast = random_uniform(stream, 3, options.contrast_min, options.contrast_max)};
  return binned(sensor_pixel, options.binning);
}

Sensor sensor_of(const SensorOptions& options, Stream stream) {
  return {.settings = draw_sensor(options, make_stream(stream.key, "settings")),
          .noise = make_stream(stream.key, "noise")};
}

}  // namespace cps
