#pragma once

#include <string>

namespace cps {

/// A date and a time of day, UTC.
struct Moment {
  int year = 2025, month = 6, day = 21;
  double hour = 12;  ///< 0 … 24
  /// Empty if there is such a day, between 1950 and 2050; otherwise one line that says what a moment must be.
  std::string fault() const;
};

/// `2025-06-21`
std::string date_text(const Moment& moment);
/// `09:05:30`, whole seconds.
std::string time_text(const Moment& moment);

/// The position of the sun's centre, without refraction (which raises it by 0.5° at the horizon, 0.02° at
/// 45°).
struct SolarPosition {
  double elevation_deg = 0;  ///< above the horizon
  double azimuth_deg = 0;    ///< clockwise from north, [0, 360)
};

/// The sun's position by the Astronomical Almanac's approximate formula, accurate to 0.01° between 1950 and
/// 2050 (Michalsky 1988, The Astronomical Almanac's algorithm for approximate solar position, Solar Energy
/// 40(3)). Latitude is positive north, longitude positive east.
SolarPosition solar_position(const Moment& moment, double latitude_deg, double longitude_deg);

}  // namespace cps
