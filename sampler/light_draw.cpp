#include "sampler/light_draw.h"

#include <chrono>
#include <stdexcept>

namespace cps {
namespace {

constexpr int max_moment_attempts = 10'000;
constexpr int drawn_year = 2025;

enum WeatherNumber : std::uint64_t { weather, haze };
/// Drawn again in each attempt, from a stream of its own.
enum MomentNumber : std::uint64_t { day_of_year, hour };

bool is_between(double value, double low, double high) {
  return value >= low && value <= high;
}

Moment draw_moment(const LightOptions& options, Stream draw) {
  using namespace std::chrono;
  const auto days_in_span = static_cast<std::uint64_t>(options.day_max - options.day_min + 1);
  const auto day = static_cast<int>(random_below(draw, day_of_year, days_in_span));
  const year_month_day date = sys_days(year(drawn_year) / 1 / 1) + days(options.day_min - 1 + day);
  return {.year = drawn_year,
          .month = static_cast<int>(static_cast<unsigned>(date.month())),
          .day = static_cast<int>(static_cast<unsigned>(date.day())),
          .hour = random_uniform(draw, hour, 0, 24)};
}

Weather draw_weather(const LightOptions& options, Stream stream) {
  const double u = random_uniform(stream, weather);
  if (u < options.clear_share) return Weather::clear;
  return u < options.clear_share + options.hazy_share ? Weather::hazy : Weather::overcast;
}

}  // namespace

std::string to_string(Weather weather) {
  switch (weather) {
    case Weather::clear:
      return "clear";
    case Weather::hazy:
      return "hazy";
    case Weather::overcast:
      break;
  }
  return "overcast";
}

std::string LightOptions::fault() const {
  if (!is_between(latitude_deg, -90, 90)) return "latitude_deg: must lie in [-90, 90]";
  if (!is_between(longitude_deg, -180, 180)) return "longitude_deg: must lie in [-180, 180]";
  if (!is_between(day_min, 1, 365) || !is_between(day_max, day_min, 365))
    return "day_min ≤ day_max: must lie in [1, 365]";
  if (!is_between(sun_elevation_min_deg, 1, 90) ||
      !is_between(sun_elevation_max_deg, sun_elevation_min_deg, 90))
    return "sun_elevation_min_deg ≤ sun_elevation_max_deg: must lie in [1, 90]";
  if (!is_between(clear_share, 0, 1) || !is_between(hazy_share, 0, 1 - clear_share))
    return "clear_share, hazy_share: must lie in [0, 1], and their sum too";
  if (!is_between(turbidity_min, 2, 10) || !is_between(turbidity_max, turbidity_min, 10))
    return "turbidity_min ≤ turbidity_max: must lie in [2, 10]";
  if (!is_between(hazy_turbidity_min, 2, 10) || !is_between(hazy_turbidity_max, hazy_turbidity_min, 10))
    return "hazy_turbidity_min ≤ hazy_turbidity_max: must lie in [2, 10]";
  return "";
}

DrawnLight draw_light(const LightOptions& options, Stream stream) {
  DrawnLight light{.moment = {}, .weather = draw_weather(options, stream), .daylight = {}};
  Daylight& daylight = light.daylight;
  if (light.weather == Weather::overcast) daylight.sky = SkyModel::overcast;
  daylight.turbidity =
      light.weather == Weather::hazy
          ? random_uniform(stream, haze, options.hazy_turbidity_min, options.hazy_turbidity_max)
          : random_uniform(stream, haze, options.turbidity_min, options.turbidity_max);
  for (int attempt = 0; attempt < max_moment_attempts; ++attempt) {
    light.moment = draw_moment(options, substream(make_stream(stream.key, "moment"), attempt));
    const SolarPosition sun = solar_position(light.moment, options.latitude_deg, options.longitude_deg);
    if (!is_between(sun.elevation_deg, options.sun_elevation_min_deg, options.sun_elevation_max_deg))
      continue;
    daylight.sun_elevation_deg = sun.elevation_deg;
    daylight.sun_azimuth_deg = sun.azimuth_deg;
    return light;
  }
  throw std::runtime_error(
      "recipe: sun_elevation_min_deg, sun_elevation_max_deg: at latitude_deg, from day_min to day_max, the "
      "sun does not reach that range; widen it");
}

}  // namespace cps
