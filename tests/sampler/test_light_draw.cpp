#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "sampler/light_draw.h"

using namespace cps;

namespace {

DrawnLight light_of(const LightOptions& options, int i) {
  return draw_light(options, substream(make_stream(1, "condition"), i));
}

}  // namespace

TEST_CASE("the drawn sun is the sun of its date, hour and place, as high as the options want") {
  const LightOptions options;
  std::set<int> months;
  int before_noon = 0;
  constexpr int draws = 1000;
  for (int i = 0; i < draws; ++i) {
    const DrawnLight light = light_of(options, i);
    const SolarPosition sun = solar_position(light.moment, options.latitude_deg, options.longitude_deg);
    CHECK(light.daylight.sun_elevation_deg == sun.elevation_deg);
    CHECK(light.daylight.sun_azimuth_deg == sun.azimuth_deg);
    CHECK(sun.elevation_deg >= options.sun_elevation_min_deg);
    CHECK(sun.elevation_deg <= options.sun_elevation_max_deg);
    if (sun.elevation_deg > 45) CHECK(std::abs(sun.azimuth_deg - 180) < 75);  // Karlsruhe
    CHECK(light.daylight.fault() == "");
    months.insert(light.moment.month);
    before_noon += sun.azimuth_deg < 180;
  }
  CHECK(months.size() == 12);
  CHECK(std::abs(before_noon - draws / 2) < 4 * std::sqrt(draws / 4.0));
}

TEST_CASE("clear, hazy and overcast skies have their shares and their haze") {
  const LightOptions options;
  std::map<Weather, int> count;
  constexpr int draws = 2000;
  for (int i = 0; i < draws; ++i) {
    const DrawnLight light = light_of(options, i);
    ++count[light.weather];
    CHECK((light.daylight.sky == SkyModel::overcast) == (light.weather == Weather::overcast));
    if (light.weather == Weather::hazy) CHECK(light.daylight.turbidity >= options.hazy_turbidity_min);
    if (light.weather == Weather::clear) CHECK(light.daylight.turbidity <= options.turbidity_max);
  }
  const auto is_share = [&](Weather weather, double share) {
    return std::abs(count[weather] - draws * share) < 4 * std::sqrt(draws * share * (1 - share));
  };
  CHECK(is_share(Weather::clear, options.clear_share));
  CHECK(is_share(Weather::hazy, options.hazy_share));
}

TEST_CASE("days are drawn from the options' span, and a sun that never stands so is refused") {
  LightOptions options;
  options.day_min = options.day_max = 172;
  CHECK(date_text(light_of(options, 0).moment) == "2025-06-21");
  options.latitude_deg = 80;
  options.sun_elevation_min_deg = 40;
  CHECK_THROWS_WITH(light_of(options, 0),
                    Catch::Contains("sun_elevation_min_deg") && Catch::Contains("latitude_deg"));
}
