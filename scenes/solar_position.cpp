#include "scenes/solar_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "numbers/angles.h"

namespace cps {
namespace {

using namespace std::chrono;

double wrapped(double value, double period) {
  const double rest = std::fmod(value, period);
  return rest < 0 ? rest + period : rest;
}

year_month_day date_of(const Moment& moment) {
  return {year(moment.year), month(static_cast<unsigned>(moment.month)),
          std::chrono::day(static_cast<unsigned>(moment.day))};
}

/// Days since noon of 1 January 2000 (J2000).
double days_since_2000(const Moment& moment) {
  const auto days = sys_days(date_of(moment)) - sys_days(year(2000) / 1 / 1);
  return static_cast<double>(days.count()) - 0.5 + moment.hour / 24;
}

}  // namespace

std::string Moment::fault() const {
  const bool is_possible =
      year >= 1950 && year <= 2050 && month > 0 && day > 0 && date_of(*this).ok() && hour >= 0 && hour <= 24;
  return is_possible ? "" : "date and time: must be a day from 1950 to 2050 and an hour from 0 to 24";
}

std::string date_text(const Moment& moment) {
  return fmt::format("{:04}-{:02}-{:02}", moment.year, moment.month, moment.day);
}

std::string time_text(const Moment& moment) {
  const int seconds = std::min(static_cast<int>(moment.hour * 3600), 24 * 3600 - 1);
  return fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

SolarPosition solar_position(const Moment& moment, double latitude_deg, double longitude_deg) {
  const double n = days_since_2000(moment);
  const double mean_longitude_deg = 280.460 + 0.9856474 * n;
  const double anomaly = radians(357.528 + 0.9856003 * n);
  const double ecliptic =
      radians(mean_longitude_deg + 1.915 * std::sin(anomaly) + 0.020 * std::sin(2 * anomaly));
  const double obliquity = radians(23.439 - 0.0000004 * n);
  const double right_ascension = std::atan2(std::cos(obliquity) * std::sin(ecliptic), std::cos(ecliptic));
  const double declination = std::asin(std::sin(obliquity) * std::sin(ecliptic));

  const double sidereal_hours = 6.697375 + 0.0657098242 * n + moment.hour;  // Greenwich, mean
  const double hour_angle = radians(15 * sidereal_hours + longitude_deg) - right_ascension;
  const double latitude = radians(latitude_deg);
  const double sine = std::sin(declination) * std::sin(latitude) +
                      std::cos(declination) * std::cos(latitude) * std::cos(hour_angle);
  const double east = -std::cos(declination) * std::sin(hour_angle);
  const double north = std::sin(declination) * std::cos(latitude) -
                       std::cos(declination) * std::sin(latitude) * std::cos(hour_angle);
  // Not by degrees(), which rounds 180 / π: datasets keep their bytes.
  constexpr double degree = radians(1);
  return {.elevation_deg = std::asin(std::clamp(sine, -1.0, 1.0)) / degree,
          .azimuth_deg = wrapped(std::atan2(east, north) / degree, 360)};
}

}  // namespace cps
