#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "renderer/lights/atmosphere.h"

using namespace cps;

namespace {

Vec3 at_elevation(double deg, double azimuth_deg = 0) {
  const double e = deg * std::numbers::pi / 180, a = azimuth_deg * std::numbers::pi / 180;
  return Eigen::Vector3d(std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)).cast<float>();
}

}  // namespace

TEST_CASE("Sunlight before the atmosphere has the solar illuminance constant") {
  // 133.1 klx (Darula, Kittler & Gueymard 2005). The observer's fit and the bins cost about one per cent.
  CHECK(luminance(to_rec709(solar_irradiance())) == Approx(133.1).epsilon(0.02));
}

TEST_CASE("The balanced white is a daylight of 5500 K") {
  // Planck's radiation at 5500 K is almost D55, a little towards purple: neutral but for that.
  const Spectrum m = wavelengths_um() * 1e-6f;
  Spectrum planck;
  for (int i = 0; i < 16; ++i)
    planck[i] = static_cast<float>(std::pow(5e-7 / m[i], 5) / (std::exp(0.014388 / (m[i] * 5500)) - 1));
  const Color white = to_rec709(planck);
  CHECK(white.x() / white.y() == Approx(1).margin(0.08));
  CHECK(white.z() / white.y() == Approx(1).margin(0.08));
}

TEST_CASE("Sunlight thins with the air it crosses, as Beer's law says") {
  const Atmosphere air = make_atmosphere(3);
  // At the zenith the haze's optical depth is β λ^−1.3 and the air's Rayleigh depth near 0.098 at 550 nm;
  // ozone's near 0.03. At 555 nm together exp(−(0.199 + 0.098 + 0.03)) = 0.72 of 133 klx.
  CHECK(luminance(sun_irradiance(air, {0, 1, 0})) == Approx(133.1 * 0.72).epsilon(0.03));
  // Two air masses at 30°.
  CHECK(luminance(sun_irradiance(air, at_elevation(30))) == Approx(133.1 * 0.72 * 0.72).epsilon(0.04));
  CHECK(luminance(sun_irradiance(make_atmosphere(6), at_elevation(30))) <
        luminance(sun_irradiance(air, at_elevation(30))));
  CHECK(sun_irradiance(air, at_elevation(-1)).maxCoeff() == 0);
}

TEST_CASE("A low sun is redder, and the sky bluer than the sun") {
  const Atmosphere air = make_atmosphere(2.5);
  const Color high = sun_irradiance(air, at_elevation(60)), low = sun_irradiance(air, at_elevation(5));
  CHECK(low.x() / low.z() > 2 * high.x() / high.z());
  const Color zenith = sky_radiance(air, {0, 1, 0}, at_elevation(40));
  CHECK(zenith.z() / zenith.x() > 1.8f);
}

TEST_CASE("The sky has the light that the sun lost, brightest around the sun") {
  const Vec3 sun = at_elevation(45);
  const Atmosphere air = make_atmosphere(3);
  // Diffuse horizontal illuminance under clear sky and a sun at 45°: 10 to 20 klx (Kittler, Kocifaj & Darula
  // 2012).
  double diffuse = 0;
  constexpr int rows = 24, columns = 48;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const double elevation = (r + 0.5) * 90.0 / rows, azimuth = (c + 0.5) * 360.0 / columns;
      const double e = elevation * std::numbers::pi / 180;
      const double cosine_sr =
          std::sin(e) * std::cos(e) * (std::numbers::pi / 2 / rows) * (2 * std::numbers::pi / columns);
      diffuse += cosine_sr * luminance(sky_radiance(air, at_elevation(elevation, azimuth), sun));
    }
  }
  // Of the light that the beam loses, air sends half down and haze most of it; ozone and haze swallow a
  // little.
  const double lost = 133.1 * sun.y() - luminance(sun_irradiance(air, sun)) * sun.y();
  CAPTURE(diffuse, lost);
  CHECK(diffuse > 0.5 * lost);
  CHECK(diffuse < 0.9 * lost);
  // Brighter around the sun and at the horizon than in the darkest region, 90° from the sun.
  const float darkest = luminance(sky_radiance(air, at_elevation(45, 180), sun));
  CHECK(luminance(sky_radiance(air, at_elevation(50), sun)) > 4 * darkest);
  CHECK(luminance(sky_radiance(air, at_elevation(3, 90), sun)) > darkest);
}

TEST_CASE("Every turbidity and sun gives finite light") {
  for (double turbidity : {1.7, 3.0, 10.0}) {
    const Atmosphere air = make_atmosphere(turbidity);
    for (double sun : {0.0, 1.0, 20.0, 90.0}) {
      for (double elevation : {0.0, 0.01, 1.0, 45.0, 90.0}) {
        const Color c = sky_radiance(air, at_elevation(elevation), at_elevation(sun));
        CHECK(c.isFinite().all());
        CHECK(c.minCoeff() >= 0);
        CHECK(c.maxCoeff() > 0);
      }
    }
  }
}
