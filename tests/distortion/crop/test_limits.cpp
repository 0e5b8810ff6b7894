#include <catch2/catch.hpp>

#include "distortion/certificate/displacement.h"
#include "distortion/crop/limits.h"
#include "numbers/angles.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

namespace {
constexpr Coefficient all[]{Coefficient::k1, Coefficient::k2, Coefficient::k3, Coefficient::p1,
                            Coefficient::p2};
}

TEST_CASE("values inside the limits are within the bounds, values outside are not") {
  const Stream stream = make_stream(13, "limits");
  const LensBounds bounds;
  for (int i = 0; i < 40; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const auto box = frame_on_plane(camera);
    Distortion lens;
    // Draws one coefficient after the other, in a different order for each lens, as the sampler does.
    for (int k = 0; k < 5; ++k) {
      const Coefficient which = all[(i + k * (1 + i % 4)) % 5];
      const Interval limits = coefficient_limits(lens, which, box, bounds);
      REQUIRE(limits.low <= 0);
      REQUIRE(limits.high >= 0);
      for (int step = 0; step <= 10; ++step) {
        Distortion inside = lens;
        coefficient(inside, which) = limits.low + (limits.high - limits.low) * step / 10;
        CHECK(is_within(bounds, inside, box));
      }
      for (const double end : {limits.low, limits.high}) {
        Distortion outside = lens;
        coefficient(outside, which) = end + 1e-4 * (end > 0 ? 1 : -1) * (limits.high - limits.low);
        CHECK_FALSE(is_within(bounds, outside, box));
      }
      coefficient(lens, which) = random_uniform(substream(stream, i), k, limits.low, limits.high);
    }
  }
}

TEST_CASE("limits of k1 alone in closed form") {
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-0.8, -0.6), Eigen::Vector2d(0.8, 0.6));
  // Barrel: 1 + 3 k1 ≥ .15. Pincushion: 1 + 3 k1 ≤ 1.8. Displacement |k1| ≤ .35 does not bind.
  const Interval k1 = coefficient_limits({}, Coefficient::k1, box, {});
  CHECK(k1.low == Approx(-0.85 / 3).margin(1e-5));
  CHECK(k1.high == Approx(0.8 / 3).margin(1e-5));
  const Interval capped = coefficient_limits({}, Coefficient::k1, box, {.max_displacement = 0.1});
  CHECK(capped.low == Approx(-0.1).margin(1e-5));
  CHECK(capped.high == Approx(0.1).margin(1e-5));
  const Interval p1 = coefficient_limits({.p2 = 0.009}, Coefficient::p1, box, {});
  CHECK(p1.high == Approx(0.012).margin(1e-9));
  CHECK(p1.low == -p1.high);
}

TEST_CASE("unusable bounds are named") {
  CHECK(LensBounds{}.fault() == "");
  CHECK_THAT(LensBounds{.min_eigenvalue = 1}.fault(), Catch::StartsWith("min_eigenvalue: "));
  CHECK_THAT(LensBounds{.max_displacement = 0}.fault(), Catch::StartsWith("max_displacement: "));
  CHECK_THAT(LensBounds{.max_tangential = -1}.fault(), Catch::StartsWith("max_tangential: "));
  CHECK(PrincipalPointBounds{}.fault() == "");
  CHECK_THAT(PrincipalPointBounds{.max_shift_y = 0.5}.fault(), Catch::StartsWith("max_shift: "));
  CHECK_THAT(PrincipalPointBounds{.max_zoom = 0.9}.fault(), Catch::StartsWith("max_zoom: "));
}

TEST_CASE("a Gibbs sweep starts from the value at hand when 0 is not allowed") {
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-0.8, -0.6), Eigen::Vector2d(0.8, 0.6));
  const Distortion lens{.k1 = -0.35, .k2 = 0.15};
  REQUIRE(is_within({}, lens, box));
  const Interval k2 = coefficient_limits(lens, Coefficient::k2, box, {});
  CHECK(k2.low > 0);
  CHECK(k2.low < 0.15);
  CHECK(k2.high > 0.15);
  CHECK_THROWS_WITH(coefficient_limits({.k1 = -0.9}, Coefficient::k3, box, {}), Catch::Contains("bounds"));
}

TEST_CASE("the default bounds contain KITTI's cameras in their base frames") {
  // Scaled coefficients of cameras 0 and 3 at base H-FOV 86.3° and 96.1° (half diagonal as the unit).
  const Pinhole base = pinhole_from_hfov(1392, 512, radians(90));
  const auto box = frame_on_plane(base);
  const double unit = 0.5 * box.diagonal().norm();
  for (const Distortion& scaled : {Distortion{-0.372, 0.203, -0.071}, Distortion{-0.512, 0.354, -0.150}})
    CHECK(is_within({}, rescaled(scaled, 1 / unit), box));
}

TEST_CASE("principal point limits respect the zoom cap and the shift") {
  const Pinhole base = pinhole_from_hfov(1392, 512, radians(90));
  const Eigen::Vector2d centre(base.cx, base.cy);
  const Interval free = principal_point_limits({}, base, centre, PrincipalPointAxis::cy, {});
  CHECK(free.low == Approx(base.cy - 0.08 * 512));
  CHECK(free.high == Approx(base.cy + 0.08 * 512));
  // Without distortion a shift by d px costs zoom 1 + d / (W/2).
  const Interval capped =
      principal_point_limits({}, base, centre, PrincipalPointAxis::cx, {.max_zoom = 1.02});
  CHECK(capped.high == Approx(base.cx + 0.02 * 696).margin(1e-4));
  CHECK(capped.low == Approx(base.cx - 0.02 * 696).margin(1e-4));
  const Interval none =
      principal_point_limits({.k1 = -0.1}, base, centre, PrincipalPointAxis::cx, {.max_zoom = 1.01});
  CHECK(none.low == base.cx);
  CHECK(none.high == base.cx);
}
