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
  return {};
}

SensorSettings draw_sensor(const SensorOptions& options, Stream stream) {
  // Log-uniform, because noise levels compare as ratios.
  const double full_well = std::exp(
      random_uniform(stream, 1, std::log(options.full_well_min_e), std::log(options.full_well_max_e)));
  return {.exposure_bias_ev =
              random_uniform(stream, 0, options.exposure_bias_min_ev, options.exposure_bias_max_ev),
          .full_well_e = full_well,
          .read_noise_e = random_uniform(stream, 2, options.read_noise_min_e, options.read_noise_max_e)};
}

Sensor sensor_of(const SensorOptions& options, Stream stream) {
  return {.settings = draw_sensor(options, make_stream(stream.key, "settings")),
          .noise = make_stream(stream.key, "noise")};
}

}  // namespace cps
