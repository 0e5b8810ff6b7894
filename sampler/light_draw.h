#pragma once

#include <string>

#include "random/counter_hash.h"
#include "scenes/daylight.h"
#include "scenes/solar_position.h"

namespace cps {

enum class Weather { clear, hazy, overcast };
std::string to_string(Weather weather);

/// Where a recipe's scenes lie, and the dates, sun elevations and weather to draw conditions from.
struct LightOptions {
  double latitude_deg = 49.01, longitude_deg = 8.40;  ///< north and east; Karlsruhe
  int day_min = 1, day_max = 365;                     ///< days of the year, 1 January is 1
  double sun_elevation_min_deg = 10, sun_elevation_max_deg = 65;
  double clear_share = 0.5, hazy_share = 0.25;  ///< shares of the conditions; the rest is overcast
  double turbidity_min = 2, turbidity_max = 3.5;
  double hazy_turbidity_min = 4, hazy_turbidity_max = 8;

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// The light of one condition, and the moment and weather that it belongs to.
struct DrawnLight {
  Moment moment;
  Weather weather = Weather::clear;
  Daylight daylight;
};

/// Draws a day of 2025 and an hour, uniform among those with the sun's elevation in the options' range, and
/// the weather by its shares. Throws std::runtime_error if the sun never reaches that range.
DrawnLight draw_light(const LightOptions& options, Stream stream);

}  // namespace cps
