#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/models/inverse/unproject.h"
#include "distortion/models/warp/seen_hfov.h"
#include "numbers/angles.h"

using namespace cps;

TEST_CASE("the camera for an H-FOV has the focal length of the lens' closed form") {
  for (const double hfov_deg : {20.0, 90.0, 160.0, 230.0}) {
    const double half = radians(hfov_deg) / 2;
    const auto focal = [&](const LensModel& lens) {
      const auto camera = camera_from_seen_hfov(lens, 640, 480, 2 * half);
      return camera ? camera->pinhole.fx : 0;
    };
    CHECK(focal(KannalaBrandt{}) == Approx(320 / half).epsilon(1e-9));
    CHECK(focal(UnifiedSpherical{1, {}}) == Approx(320 / std::tan(half / 2)).epsilon(1e-9));
    CHECK(focal(UnifiedSpherical{.8, {}}) ==
          Approx(320 * (std::cos(half) + .8) / std::sin(half)).epsilon(1e-9));
    if (half < radians(85)) CHECK(focal(Distortion{}) == Approx(320 / std::tan(half)).epsilon(1e-9));
  }
}

TEST_CASE("with tangential terms too, the angle between the ends of the row is the H-FOV") {
  for (const LensModel& lens : {LensModel{RationalLens{.k1 = .1, .k4 = .2, .p1 = .004, .p2 = -.006}},
                                LensModel{UnifiedSpherical{.6, {.k1 = -.05, .p1 = .003, .p2 = .005}}}}) {
    const auto camera = camera_from_seen_hfov(lens, 640, 480, radians(80));
    REQUIRE(camera);
    const RayRegion region = certify_region(lens).region;
    const auto left = unproject(lens, region, to_plane(camera->pinhole, {-.5, camera->pinhole.cy})),
               right = unproject(lens, region, to_plane(camera->pinhole, {639.5, camera->pinhole.cy}));
    REQUIRE((left && right));
    CHECK(std::acos(left->dot(*right)) == Approx(radians(80)).epsilon(1e-6));
  }
}

TEST_CASE("an H-FOV that the lens cannot show has no camera") {
  CHECK_FALSE(camera_from_seen_hfov(Distortion{}, 640, 480, radians(181)));
  // ξ = .5: up to arccos(−.5) = 120° off the axis.
  CHECK(camera_from_seen_hfov(UnifiedSpherical{.5, {}}, 640, 480, radians(230)));
  CHECK_FALSE(camera_from_seen_hfov(UnifiedSpherical{.5, {}}, 640, 480, radians(250)));
  // dr/dθ = 1 − .6 θ² ends at 74°.
  CHECK(camera_from_seen_hfov(KannalaBrandt{-.2, 0, 0, 0}, 640, 480, radians(140)));
  CHECK_FALSE(camera_from_seen_hfov(KannalaBrandt{-.2, 0, 0, 0}, 640, 480, radians(155)));
}
