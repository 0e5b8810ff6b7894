#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "random/counter_hash.h"
#include "renderer/lights/sky_models.h"
#include "tests/renderer/statistics.h"

using namespace cps;

namespace {

using std::numbers::pi;

Eigen::Vector2f uniform_pair(int i) {
  const Stream stream = make_stream(9, "sky");
  return {static_cast<float>(random_uniform(stream, 2 * i)),
          static_cast<float>(random_uniform(stream, 2 * i + 1))};
}

/// ∫ over all directions, midpoints in (y, azimuth).
template <class F>
double integrate_sphere(F f) {
  constexpr int rows = 8000, columns = 192;
  double sum = 0;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const double y = 2 * (r + 0.5) / rows - 1, phi = 2 * pi * (c + 0.5) / columns, s = std::sqrt(1 - y * y);
      sum += f(Eigen::Vector3d(s * std::cos(phi), y, s * std::sin(phi)).cast<float>()) * 4 * pi /
             (rows * columns);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("The sky's density integrates to one") {
  for (double elevation : {5.0, 40.0, 80.0}) {
    const SkyAndSun day = make_clear_day({.sun_elevation_deg = elevation});
    CHECK(integrate_sphere([&](const Vec3& d) { return day.sky.distribution.pdf(d); }) ==
          Approx(1).epsilon(0.002));
  }
}

TEST_CASE("Sky samples follow the density that comes with them") {
  constexpr int rows = 20, columns = 24, samples = 300000;
  const SkyAndSun day = make_clear_day({.sun_elevation_deg = 30});
  const DirectionDistribution& distribution = day.sky.distribution;
  std::vector<double> observed(rows * columns), expected(rows * columns);
  for (int i = 0; i < samples; ++i) {
    const DirectionSample s = distribution.sample(uniform_pair(i));
    REQUIRE(s.direction.norm() == Approx(1).margin(1e-5));
    const int row = std::min(static_cast<int>((0.5f + 0.5f * s.direction.y()) * rows), rows - 1);
    const int column =
        std::min(static_cast<int>(turns_of_vector(s.direction.x(), s.direction.z()) * columns), columns - 1);
    ++observed[row * columns + column];
  }
  integrate_sphere([&](const Vec3& d) {
    const int row = std::min(static_cast<int>((0.5f + 0.5f * d.y()) * rows), rows - 1);
    const int column = std::min(static_cast<int>(turns_of_vector(d.x(), d.z()) * columns), columns - 1);
    expected[row * columns + column] += samples * distribution.pdf(d) * 4 * pi / (8000.0 * 192);
    return 0.0;
  });
  CHECK(chi_squared_p_value(observed, expected) > 1e-4);
}

TEST_CASE("A sample's density is the density of its direction") {
  const SkyAndSun day = make_clear_day({.sun_elevation_deg = 55, .turbidity = 5});
  int at_seam = 0;
  for (int i = 0; i < 20000; ++i) {
    const DirectionSample s = day.sky.distribution.sample(uniform_pair(i));
    at_seam += std::abs(day.sky.distribution.pdf(s.direction) / s.pdf - 1) > 1e-5;
  }
  CHECK(at_seam < 10);  // rounding may put a direction across the border of a cell
}

TEST_CASE("Drawing from the sky and by cosine, weighed against each other, estimates the sky's light") {
  const SkyAndSun day = make_clear_day({.sun_elevation_deg = 25});
  const double exact =
      integrate_sphere([&](const Vec3& d) { return luminance(day.sky.radiance(d)) * std::max(0.0f, d.y()); });
  constexpr int samples = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < samples; ++i) {
    const auto balanced = [&](const Vec3& d) {
      const double cosine = std::max(0.0f, d.y());
      return luminance(day.sky.radiance(d)) * cosine / (day.sky.distribution.pdf(d) + cosine / pi);
    };
    const Vec3 by_sky = day.sky.distribution.sample(uniform_pair(2 * i)).direction;
    const Eigen::Vector2f u = uniform_pair(2 * i + 1);
    const Vec3 by_cosine = direction_at(u.x(), std::sqrt(u.y()));
    const double v = (by_sky.y() > 0 ? balanced(by_sky) : 0.0) + balanced(by_cosine);
    sum += v;
    squares += v * v;
  }
  const double mean = sum / samples, sigma = std::sqrt((squares / samples - mean * mean) / samples);
  CHECK(std::abs(mean - exact) < 4 * sigma + 1e-3 * exact);
}

TEST_CASE("A constant sky is left to the BSDFs") {
  const Sky sky = make_constant_sky(Color(3, 2, 1));
  CHECK(make_sky_distribution(sky).empty());
  CHECK(sky.distribution.pdf({0, 1, 0}) == 0);
  CHECK((sky.radiance(Vec3(0.3f, -0.5f, 0.4f).normalized()) - Color(3, 2, 1)).abs().maxCoeff() < 1e-5f);
  CHECK(horizontal_irradiance(sky).x() == Approx(3 * pi));
}

TEST_CASE("An overcast sky is three times brighter overhead, and as bright as its elevation says") {
  const Sky sky = make_overcast_sky({.sun_elevation_deg = 30, .sky = SkyModel::overcast});
  for (float turns : {0.1f, 0.6f}) {
    for (float sine : {0.001f, 0.3f, 0.9f}) {
      const float here = luminance(sky.radiance(direction_at(turns, sine)));
      const float at_30_deg = luminance(sky.radiance(direction_at(turns, 0.5f)));
      CHECK(here / at_30_deg == Approx((1 + 2 * sine) / 2).epsilon(0.01));
    }
  }
  CHECK(luminance(horizontal_irradiance(sky)) == Approx(0.3 + 21 * 0.5).epsilon(0.002));
  const Color zenith = sky.radiance({0, 1, 0});
  CHECK(zenith.maxCoeff() < 1.35f * zenith.minCoeff());  // white, a little bluish
  const Color low =
      make_overcast_sky({.sun_elevation_deg = 10, .sky = SkyModel::overcast}).radiance({0, 1, 0});
  for (const Color& color : {zenith, low}) {  // and never pink
    CHECK(color.x() < color.y());
    CHECK(color.y() < color.z());
  }
}

TEST_CASE("A sun set by hand replaces the model's") {
  const SkyAndSun light = make_sky_and_sun({.sun_elevation_deg = 90,
                                            .sun_angular_diameter_deg = 2,
                                            .sky = SkyModel::constant,
                                            .sky_radiance = {4, 5, 6},
                                            .sun_irradiance_klx = Vec3(10, 20, 30)});
  CHECK((light.sun.radiance / light.sun.pdf - Color(10, 20, 30)).abs().maxCoeff() < 1e-4f);
  CHECK(light.sun.covers(direction_at(0.3f, std::cos(0.9f * std::numbers::pi_v<float> / 180))));
  CHECK_FALSE(light.sun.covers(direction_at(0.3f, std::cos(1.1f * std::numbers::pi_v<float> / 180))));
  CHECK(light.sky.radiance({0, 1, 0}).y() == Approx(5));
  CHECK_FALSE(make_sky_and_sun({.sky = SkyModel::overcast}).sun.shines());
}

TEST_CASE("The sun is a disc of its angular diameter, uniformly sampled") {
  const double diameter = 0.53 * pi / 180;
  const Vec3 direction = Vec3(0.3f, 0.5f, -0.4f).normalized();
  const Sun sun = make_sun(direction, diameter, Color::Constant(80));
  CHECK(1 / sun.pdf == Approx(2 * pi * (1 - std::cos(diameter / 2))).epsilon(1e-5));
  CHECK(sun.radiance.x() / sun.pdf == Approx(80));
  int inner = 0;
  constexpr int samples = 100000;
  for (int i = 0; i < samples; ++i) {
    const Vec3 d = sun.sample(uniform_pair(i));
    const double angle = std::asin((d.cast<double>().cross(direction.cast<double>())).norm());
    REQUIRE(angle < diameter / 2 * 1.001);
    inner += angle < diameter / 4;
  }
  // A quarter of the disc lies within half its radius; four standard deviations.
  CHECK(std::abs(inner - samples / 4.0) < 4 * std::sqrt(samples * 0.25 * 0.75));
  CHECK(sun.covers(direction));
  CHECK_FALSE(sun.covers((direction + Vec3(0, 0.01f, 0)).normalized()));
}

TEST_CASE("Below the horizon lies ground lit by sun and sky") {
  const SkyAndSun day = make_clear_day({.sun_elevation_deg = 50});
  const double sky =
      integrate_sphere([&](const Vec3& d) { return d.y() > 0 ? luminance(day.sky.radiance(d)) * d.y() : 0; });
  const double sunlight = luminance(day.sun.radiance) / day.sun.pdf * day.sun.direction.y();
  // Straight down the haze is thin: a Lambert surface of albedo 0.2.
  CHECK(luminance(day.sky.radiance({0, -1, 0})) == Approx(0.2 * (sky + sunlight) / pi).epsilon(0.03));
}
