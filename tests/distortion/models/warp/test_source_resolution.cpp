#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "distortion/models/warp/source_resolution.h"
#include "numbers/angles.h"

using namespace cps;

namespace {

ModelCamera equidistant(int width, int height, double focal) {
  return {"", {width, height, focal, focal, .5 * (width - 1), .5 * (height - 1)}, KannalaBrandt{}};
}

RayRegion frame_of(const ModelCamera& camera) {
  const ModelCertificate proof = certify_frame(camera, one_to_one);
  REQUIRE(proof.valid);
  return proof.region;
}

}  // namespace

TEST_CASE("pixels of a panorama under a pixel of the picture, against closed forms") {
  const Panorama panorama{4096, 2048};
  const double px_per_rad = 4096 / (2 * std::numbers::pi);
  // A pinhole is finest in its corners, along the radius: cos²θ / f.
  const ModelCamera pinhole{"", pinhole_from_hfov(640, 480, radians(100)), Distortion{}};
  const double half_diagonal = std::hypot(320, 240), f = pinhole.pinhole.fx;
  CHECK(fewest_panorama_px(panorama, pinhole, frame_of(pinhole)) ==
        Approx(px_per_rad / f / (1 + half_diagonal * half_diagonal / (f * f))).epsilon(1e-9));
  // An equidistant fisheye is finest in its corners, across the radius: sin θ / (θ f).
  const ModelCamera fisheye = equidistant(640, 480, 220);
  const double corner = half_diagonal / 220;
  CHECK(fewest_panorama_px(panorama, fisheye, frame_of(fisheye)) ==
        Approx(px_per_rad / 220 * std::sin(corner) / corner).epsilon(1e-9));
}

TEST_CASE("pixels of a picture under a pixel of another") {
  const ModelCamera wide{"", pinhole_from_hfov(800, 600, radians(100)), Distortion{}},
      narrow{"", pinhole_from_hfov(640, 480, radians(60)), Distortion{}};
  CHECK(fewest_source_px(wide, frame_of(wide), narrow, frame_of(narrow)) ==
        Approx(wide.pinhole.fx / narrow.pinhole.fx).epsilon(1e-9));
  // From a fisheye to a straight picture: coarsest in the corners, along the radius.
  const ModelCamera fisheye = equidistant(800, 800, 250);
  const double f = narrow.pinhole.fx, tangent = std::hypot(320, 240) / f;
  CHECK(fewest_source_px(fisheye, frame_of(fisheye), narrow, frame_of(narrow)) ==
        Approx(250 / f / (1 + tangent * tangent)).epsilon(1e-9));
}
