#include <catch2/catch.hpp>

#include "distortion/models/straight_angle.h"
#include "random/counter_hash.h"

using namespace cps;

TEST_CASE("the angle from the axis is the arc tangent, to rounding") {
  const Stream stream = make_stream(1, "angle from axis");
  double worst = 0, worst_ratio = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double angle = random_uniform(stream, 2 * i, 1e-6, 3.14);
    const double length = std::exp(random_uniform(stream, 2 * i + 1, -20, 20));
    const double across = length * std::sin(angle), along = length * std::cos(angle);
    const long double expected =
        std::atan2(static_cast<long double>(across), static_cast<long double>(along));
    const AxisAngle found = angle_from_axis(across, along);
    worst = std::max(worst, static_cast<double>(std::abs(found.angle_rad / expected - 1)));
    worst_ratio =
        std::max(worst_ratio, static_cast<double>(std::abs(found.per_across * across / expected - 1)));
  }
  CHECK(worst < 1e-15);
  CHECK(worst_ratio < 2e-15);
}

TEST_CASE("the angle from the axis has its limit on the axis") {
  for (const double across : {0.0, 1e-300, 1e-160, 1e-20}) {
    const AxisAngle found = angle_from_axis(across, 4);
    CHECK(found.angle_rad == Approx(across / 4).epsilon(1e-15).margin(0));
    CHECK(found.per_across == Approx(0.25).epsilon(1e-15));
  }
  CHECK(angle_from_axis(2, 0).angle_rad == Approx(std::numbers::pi / 2).epsilon(1e-15));
}

TEST_CASE("sine and cosine, to rounding") {
  const Stream stream = make_stream(2, "sine cosine");
  double worst = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double angle = random_uniform(stream, i, -100, 100);
    const SineCosine found = straight_sine_cosine(angle);
    const long double exact = angle;
    worst = std::max({worst, static_cast<double>(std::abs(found.sine - std::sin(exact))),
                      static_cast<double>(std::abs(found.cosine - std::cos(exact)))});
  }
  CHECK(worst < 3e-16);
  CHECK(straight_sine_cosine(0).sine == 0);
  CHECK(straight_sine_cosine(0).cosine == 1);
}
