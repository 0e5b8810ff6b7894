#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "numbers/angles.h"
#include "tests/trainer/street.h"
#include "trainer/calibration/targets.h"

using namespace cps;

TEST_CASE("targets turn back into the calibration they came from, in either space, at any H-FOV") {
  for (TargetSpace space : {TargetSpace::raw, TargetSpace::apparent})
    for (double hfov_deg : {30.0, 60.0, 90.0, 120.0, 150.0}) {
      CalibratedCamera truth{
          "", pinhole_from_hfov(1392, 512, radians(hfov_deg)), {-.3, .2, -.05, .004, -.007}};
      truth.pinhole.cx += 17.25;
      truth.pinhole.cy -= 31.5;
      const auto back = to_camera(to_outputs(truth, space), space, 1392, 512);
      REQUIRE(back);
      CHECK(back->pinhole.fx == Approx(truth.pinhole.fx).epsilon(1e-13));
      CHECK(back->pinhole.cx == Approx(truth.pinhole.cx).epsilon(1e-13));
      CHECK(back->pinhole.cy == Approx(truth.pinhole.cy).epsilon(1e-13));
      CHECK(back->distortion.k1 == Approx(truth.distortion.k1).epsilon(1e-13));
      CHECK(back->distortion.k2 == Approx(truth.distortion.k2).epsilon(1e-13));
      CHECK(back->distortion.k3 == Approx(truth.distortion.k3).epsilon(1e-13));
      CHECK(back->distortion.p1 == Approx(truth.distortion.p1).epsilon(1e-13));
      CHECK(back->distortion.p2 == Approx(truth.distortion.p2).epsilon(1e-13));
    }
}

TEST_CASE("apparent coefficients sum to the corner's displacement as a fraction of the half diagonal") {
  const CalibratedCamera c{"", pinhole_from_hfov(480, 270, radians(35)), {.9, -.4, .3, 0, 0}};
  const Outputs apparent = to_outputs(c, TargetSpace::apparent);
  const Eigen::Vector2d corner = frame_on_plane(c.pinhole).max();
  const double moved = distort(c.distortion, corner).norm() / corner.norm() - 1;
  CHECK(apparent[1] + apparent[2] + apparent[3] == Approx(moved).epsilon(1e-12));

  // The same bend at another H-FOV has other raw and equal apparent coefficients.
  const double ratio = c.pinhole.fx / pinhole_from_hfov(480, 270, radians(120)).fx, r2 = ratio * ratio;
  const CalibratedCamera wide{
      "", pinhole_from_hfov(480, 270, radians(120)), {.9 / r2, -.4 / (r2 * r2), .3 / (r2 * r2 * r2), 0, 0}};
  for (int i = 1; i < 6; ++i)
    CHECK(to_outputs(wide, TargetSpace::apparent)[i] == Approx(apparent[i]).margin(1e-12));
}

TEST_CASE("outputs that describe no camera give none") {
  const Outputs good{1.2, 0, 0, 0, 0, 0, .5, .5};
  CHECK(to_camera(good, TargetSpace::apparent, 480, 270));
  for (double fov : {-.1, 0.0, 3.2, std::numeric_limits<double>::quiet_NaN()}) {
    Outputs bad = good;
    bad[0] = fov;
    CHECK_FALSE(to_camera(bad, TargetSpace::apparent, 480, 270));
  }
}

TEST_CASE("standardised training targets have mean 0 and variance 1, and turn back exactly") {
  std::vector<Outputs> targets;
  for (int i = 0; i < 200; ++i)
    targets.push_back(to_outputs(draw_calibration({480, 270}, 40 + i % 60, i + 1), TargetSpace::apparent));
  const Standardisation by = fit_standardisation(targets);
  Outputs sum{}, squares{};
  for (const Outputs& t : targets) {
    const Outputs s = standardise(t, by), back = unstandardise(s, by);
    for (int i = 0; i < output_count; ++i) {
      sum[i] += s[i] / 200;
      squares[i] += s[i] * s[i] / 200;
      CHECK(back[i] == Approx(t[i]).epsilon(1e-12).margin(1e-15));
    }
  }
  for (int i = 0; i < output_count; ++i) {
    CHECK(sum[i] == Approx(0).margin(1e-12));
    CHECK(squares[i] == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("an output that does not vary keeps its constant") {
  const std::vector<Outputs> targets(5, Outputs{1.1, .1, .2, .3, 0, 0, .51, .49});
  const Standardisation by = fit_standardisation(targets);
  for (int i = 0; i < output_count; ++i) {
    CHECK(by.deviation[i] == 1);
    CHECK(standardise(targets[0], by)[i] == Approx(0).margin(1e-15));
  }
}
