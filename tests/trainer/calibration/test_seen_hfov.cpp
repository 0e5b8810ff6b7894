#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "numbers/angles.h"
#include "tests/trainer/street.h"
#include "trainer/calibration/certified_lens.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/calibration/seen_hfov.h"

using namespace cps;

TEST_CASE("the ideal radius is the one that the lens sends to the distorted radius") {
  for (const Outputs& lens : {Outputs{1, -.25, .08, -.01}, Outputs{1, .3, -.05, .02}, Outputs{1, 0, 0, 0}})
    for (double distorted : {.1, .5, .94, 1.0}) {
      const auto [radius, slope] = ideal_radius(lens, distorted);
      const Distortion d{lens[1], lens[2], lens[3]};
      CHECK(distort(d, {radius, 0}).x() == Approx(distorted).epsilon(1e-12));
      CHECK(distortion_jacobian(d, {radius, 0})(0, 0) == Approx(slope).epsilon(1e-9));
    }
}

TEST_CASE("a lens that folds first gives the radius of the fold") {
  // r − r³ turns back at 1/√3, where it has reached .385.
  const IdealRadius fold = ideal_radius({1, -1, 0, 0}, .5);
  CHECK(fold.radius == Approx(1 / std::sqrt(3)).epsilon(1e-9));
  CHECK(fold.slope == 0);
  CHECK(ideal_radius({1, -1, 0, 0}, .38).slope > 0);
}

TEST_CASE("the H-FOV that is seen is the angle between the rays of the middle row's ends") {
  const CalibratedCamera camera{"", pinhole_from_hfov(1392, 512, radians(72)), {-.37, .2, -.06, 0, 0}};
  const FrameCertificate frame = certify_frame(camera.distortion, camera.pinhole, one_to_one);
  REQUIRE(frame.valid());
  const double end = frame_on_plane(camera.pinhole).max().x();
  const auto ideal = undistort(camera.distortion, frame.rectangle, {end, 0});
  REQUIRE(ideal);
  const double seen = to_outputs(camera, TargetSpace::seen)[0];
  CHECK(seen == Approx(2 * std::atan(ideal->x())).epsilon(1e-10));
  CHECK(degrees(seen) > 80);  // where the label says 72
}

TEST_CASE("outputs in the space seen turn back into the calibration they came from") {
  for (double hfov_deg : {30.0, 70.0, 110.0})
    for (const Distortion& lens : {Distortion{-.2, .05, -.004, .001, -.002}, Distortion{.1, -.02, 0, 0, 0}}) {
      const double unit = 1 / std::tan(radians(hfov_deg) / 2);
      const CalibratedCamera truth{"", pinhole_from_hfov(480, 270, radians(hfov_deg)), rescaled(lens, unit)};
      const auto back = to_camera(to_outputs(truth, TargetSpace::seen), TargetSpace::seen, 480, 270);
      REQUIRE(back);
      CHECK(back->pinhole.fx == Approx(truth.pinhole.fx).epsilon(1e-11));
      CHECK(back->distortion.k1 == Approx(truth.distortion.k1).epsilon(1e-11));
      CHECK(back->distortion.k3 == Approx(truth.distortion.k3).epsilon(1e-10).margin(1e-14));
      CHECK(back->distortion.p2 == Approx(truth.distortion.p2).epsilon(1e-11));
    }
}

TEST_CASE("outputs whose lens folds are pulled until it does not and keep the H-FOV seen") {
  const Outputs folding{radians(80), -.9, .1, 0, .01, 0, .5, .5};
  const Outputs pulled = pulled_to_one_to_one(folding, TargetSpace::seen, {480, 270});
  CHECK(is_one_to_one(*to_camera(pulled, TargetSpace::seen, 480, 270)));
  CHECK(pulled[0] == folding[0]);
  const double kept = pulled[1] / folding[1];
  CHECK(kept < 1);
  CHECK(pulled[4] == Approx(kept * folding[4]));
  Outputs more = folding;
  for (int i = 1; i <= 5; ++i) more[i] *= kept + 1e-4;
  CHECK_FALSE(is_one_to_one(*to_camera(more, TargetSpace::seen, 480, 270)));

  const Outputs good{radians(80), -.2, .02, 0, 0, 0, .5, .5};
  CHECK(pulled_to_one_to_one(good, TargetSpace::seen, {480, 270}) == good);
}
