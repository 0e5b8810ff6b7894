#include <catch2/catch.hpp>
#include <cmath>

#include "scenes/solar_position.h"

using namespace cps;

TEST_CASE("the sun's position agrees with NREL's worked example") {
  // Reda & Andreas 2008, Solar Position Algorithm, NREL/TP-560-34302, appendix A.5: 17 October 2003, 12:30:30
  // at UTC−7; elevation without refraction 39.872046°, azimuth 194.340241°.
  const SolarPosition sun = solar_position({.year = 2003, .month = 10, .day = 17, .hour = 19.5 + 30 / 3600.0},
                                           39.742476, -105.1786);
  CHECK(sun.elevation_deg == Approx(39.872046).margin(0.015));
  CHECK(sun.azimuth_deg == Approx(194.340241).margin(0.015));
}

TEST_CASE("the sun's declination agrees with Meeus' example") {
  // Meeus, Astronomical Algorithms (1998), example 25.a: 13 October 1992, 0 h TD: declination −7.78507°. From
  // the pole, the elevation is the declination.
  const SolarPosition sun = solar_position({.year = 1992, .month = 10, .day = 13, .hour = 0}, 90, 0);
  CHECK(sun.elevation_deg == Approx(-7.78507).margin(0.012));
}

TEST_CASE("equinoxes and solstices") {
  // June 2025: solstice on the 21st at 2:42 UTC, equinox on 20 March at 9:01 UTC (USNO).
  CHECK(solar_position({2025, 6, 21, 2.7}, 90, 0).elevation_deg == Approx(23.437).margin(0.01));
  CHECK(solar_position({2025, 3, 20, 9.02}, 90, 0).elevation_deg == Approx(0).margin(0.01));
  // At true noon of an equinox the sun is 90° − |latitude| high: south of Karlsruhe, north of Sydney.
  double highest = 0, azimuth = 0;
  for (double hour = 9; hour < 15; hour += 0.01)
    if (const SolarPosition sun = solar_position({2025, 3, 20, hour}, 49, 8.4); sun.elevation_deg > highest)
      highest = sun.elevation_deg, azimuth = sun.azimuth_deg;
  CHECK(highest == Approx(41).margin(0.1));
  CHECK(azimuth == Approx(180).margin(0.2));
  CHECK(std::cos(solar_position({2025, 3, 20, 2}, -33.87, 151.2).azimuth_deg * 3.14159265 / 180) > 0.99);
  // It rises in the east.
  CHECK(solar_position({2025, 3, 20, 6}, 49, 8.4).azimuth_deg == Approx(96.5).margin(3));
}

TEST_CASE("dates are checked and formatted") {
  CHECK(Moment{2024, 2, 29, 0}.fault() == "");
  for (const Moment& moment : {Moment{2025, 2, 29, 0}, Moment{2025, 13, 1, 0}, Moment{2025, 1, 0, 0},
                               Moment{1949, 1, 1, 0}, Moment{2025, 1, 1, 24.5}, Moment{2025, 1, 1, NAN}})
    CHECK_THAT(moment.fault(), Catch::StartsWith("date and time: "));
  CHECK(date_text({2025, 6, 1, 0}) == "2025-06-01");
  CHECK(time_text({2025, 6, 1, 9 + 5 / 60.0 + 30.5 / 3600}) == "09:05:30");
  CHECK(time_text({2025, 6, 1, 24}) == "23:59:59");
}
