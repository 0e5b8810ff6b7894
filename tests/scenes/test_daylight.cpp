#include <catch2/catch.hpp>
#include <cmath>

#include "scenes/daylight.h"

using cps::Daylight;
using cps::direction_to_sun;
using Eigen::Vector3f;

TEST_CASE("azimuth and elevation give the direction to the sun") {
  CHECK(direction_to_sun({.sun_elevation_deg = 0, .sun_azimuth_deg = 0}).isApprox(Vector3f(0, 0, -1), 1e-6f));
  CHECK(direction_to_sun({.sun_elevation_deg = 0, .sun_azimuth_deg = 90}).isApprox(Vector3f(1, 0, 0), 1e-6f));
  CHECK(
      direction_to_sun({.sun_elevation_deg = 90, .sun_azimuth_deg = 90}).isApprox(Vector3f(0, 1, 0), 1e-6f));
  const float half = std::sqrt(0.5f);
  CHECK(direction_to_sun({.sun_elevation_deg = 45, .sun_azimuth_deg = 180})
            .isApprox(Vector3f(0, half, half), 1e-6f));
}

TEST_CASE("daylight out of range is refused by the field's name") {
  CHECK(Daylight{}.fault() == "");
  CHECK(Daylight{.sun_elevation_deg = 95}.fault() == "sun_elevation_deg = 95 must be within -6 and 90");
  CHECK(Daylight{.turbidity = std::nan("")}.fault() == "turbidity = nan must be within 1.7 and 10");
  CHECK(Daylight{.sun_angular_diameter_deg = -1}.fault() ==
        "sun_angular_diameter_deg = -1 must be within 0.01 and 20");
  CHECK(Daylight{.sun_elevation_deg = -3, .sky = cps::SkyModel::overcast}.fault() ==
        "sun_elevation_deg = -3 must be within 0 and 90");
  CHECK(Daylight{.sky = cps::SkyModel::image}.fault() == "sky_image: names no file");
  CHECK(Daylight{.sky_radiance = {1, -1, 1}}.fault() == "sky_radiance = -1 must be within 0 and 1e+09");
  CHECK(Daylight{.sun_irradiance_klx = Vector3f(1, NAN, 1)}.fault() ==
        "sun_irradiance_klx = nan must be within 0 and 1e+09");
}
