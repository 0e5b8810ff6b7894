#include <catch2/catch.hpp>

#include "distortion/certificate/frame_certificate.h"
#include "numbers/angles.h"
#include "tests/trainer/street.h"
#include "trainer/calibration/certified_lens.h"

using namespace cps;

TEST_CASE("a certified lens stays as it is") {
  const CalibratedCamera mild{"", pinhole_from_hfov(480, 270, 1.2), {-.1, .01, 0, .001, -.001}};
  REQUIRE(certify_frame(mild.distortion, mild.pinhole).valid());
  const CertifiedLens pulled = pull_to_certified(mild);
  CHECK(pulled.kept == 1);
  CHECK(pulled.camera.distortion == mild.distortion);
  CHECK(pulled.camera.pinhole == mild.pinhole);
}

TEST_CASE("a lens that folds is pulled to the edge of the certified ones, and no further") {
  for (const Distortion& lens :
       {Distortion{-3, 0, 0, 0, 0}, Distortion{-.5, -2, 4, .3, -.2}, Distortion{0, 0, -9, 0, 0}}) {
    const CalibratedCamera folding{"", pinhole_from_hfov(480, 270, radians(80)), lens};
    REQUIRE_FALSE(certify_frame(lens, folding.pinhole).valid());
    const CertifiedLens pulled = pull_to_certified(folding);
    CHECK(pulled.kept > 0);
    CHECK(pulled.kept < 1);
    CHECK(certify_frame(pulled.camera.distortion, pulled.camera.pinhole).valid());
    CHECK(pulled.camera.distortion.k1 == pulled.kept * lens.k1);
    const double more = pulled.kept + 1e-4;
    CHECK_FALSE(
        certify_frame({more * lens.k1, more * lens.k2, more * lens.k3, more * lens.p1, more * lens.p2},
                      folding.pinhole)
            .valid());
  }
}

TEST_CASE("a principal point outside the frame is moved to its edge") {
  CalibratedCamera outside{"", pinhole_from_hfov(480, 270, 1), {}};
  outside.pinhole.cx = -40;
  outside.pinhole.cy = 300;
  const CertifiedLens pulled = pull_to_certified(outside);
  CHECK(pulled.camera.pinhole.cx == 0);
  CHECK(pulled.camera.pinhole.cy == 269);
}
