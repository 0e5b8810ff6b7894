#pragma once

#include <string>

#include "random/counter_hash.h"
#include "scenes/daylight.h"
#include "scenes/solar_position.h"

namespace cps {

enum class Weather { clear, hazy, overcast };
std::string to_string(Weather weather);

/// Where, when and in what weather a recipe's scenes are seen.
struct LightOptions {
  double latitude_deg = 49.01, longitude_deg = 8.40;  ///< north and east; Karlsruhe
  int day_min = 1, day_max = 365;                     ///< of the year, 1 January is 1
  double sun_elevation_min_deg = 10, sun_elevation_max_deg = 65;
  double clear_share = 0.5, hazy_share = 0.25;  ///< of the conditions; the rest is overcast
  double turbidity_min = 2, turbidity_max = 3.5;
  double hazy_turbidity_min = 4, hazy_turbidity_max = 8;

  /// One line that names the key and its range when something is off.
  bool is_valid(std::string* why) const;
};

/// The light of one condition, and when and in what weather it falls.
struct DrawnLight {
  Moment moment;
  Weather weather = Weather::clear;
  Daylight daylight;
};

/// A day of 2025 and an hour, uniform among those whose sun stands as high as the options want it where they
/// are, and the weather by its shares. Throws std::runtime_error when the sun never stands so.
DrawnLight draw_light(const LightOptions& options, Stream stream);

}  // namespace cps
