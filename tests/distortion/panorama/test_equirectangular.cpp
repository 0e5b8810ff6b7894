#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "distortion/panorama/equirectangular.h"
#include "numbers/angles.h"
#include "random/counter_hash.h"

using namespace cps;

TEST_CASE("directions at a panorama's middle and sides and poles and seam") {
  const Panorama panorama{400, 200};
  const auto is_near = [&](double x, double y, const Eigen::Vector3d& expected) {
    return (direction(panorama, {x, y}) - expected).norm() < 1e-14;
  };
  CHECK(is_near(199.5, 99.5, {0, 0, 1}));
  CHECK(is_near(99.5, 99.5, {-1, 0, 0}));
  CHECK(is_near(299.5, 99.5, {1, 0, 0}));
  CHECK(is_near(-0.5, 99.5, {0, 0, -1}));
  CHECK(is_near(399.5, 99.5, {0, 0, -1}));
  CHECK(is_near(123, -0.5, {0, -1, 0}));
  CHECK(is_near(321, 199.5, {0, 1, 0}));
  // 36° to the right and 45° up.
  const double half = std::sqrt(0.5);
  CHECK(is_near(239.5, 49.5, {half * std::sin(radians(36)), -half, half * std::cos(radians(36))}));
  CHECK(longitude_rad(panorama, 239.5) == Approx(radians(36)));
  CHECK(latitude_rad(panorama, 49.5) == Approx(radians(45)));
}

TEST_CASE("a pixel's direction of any length leads back to it") {
  const Panorama panorama{1000, 500};
  const Stream stream = make_stream(61, "panorama pixels");
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector2d at(random_uniform(stream, 2 * i, -0.5, 999.5),
                             random_uniform(stream, 2 * i + 1, 0, 499));
    const Eigen::Vector3d ray = direction(panorama, at);
    REQUIRE(ray.norm() == Approx(1).epsilon(1e-14));
    const Eigen::Vector2d back = pixel(panorama, ray * std::exp(random_uniform(stream, i, -5, 5)));
    REQUIRE((back - at).norm() < 1e-9);
  }
}

TEST_CASE("positions of directions stay on the panorama at seam and poles") {
  const Panorama panorama{64, 32};
  for (const double x : {-1.0, -0.0, 0.0, 1e-300})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0}) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Eigen::Vector2d at = pixel(panorama, {x, y, z});
        INFO(x << " " << y << " " << z);
        CHECK((at.x() >= -0.5 && at.x() < 63.5));
        CHECK((at.y() >= -0.5 && at.y() <= 31.5));
      }
  CHECK(pixel(panorama, {0.0, 0, -1}).x() == -0.5);
  CHECK(pixel(panorama, {-0.0, 0, -1}).x() == -0.5);
  CHECK(pixel(panorama, {0, -2, 0}).y() == -0.5);
  CHECK(pixel(panorama, {0, 3, 0}).y() == 31.5);
}
