#include <catch2/catch.hpp>

#include "distortion/models/projection.h"
#include "tests/distortion/models/random_models.h"

using namespace cps;

namespace {

using std::numbers::pi;

/// The first of many angles at which the radius jumps below 0 (its denominator has passed 0) or stops
/// growing.
double first_fold(const LensModel& lens, int steps) {
  double before = 0;
  for (int i = 1; i < steps; ++i) {
    const double angle = pi * i / steps;
    const double radius = project(lens, {std::sin(angle), 0, std::cos(angle)}).point.x();
    if (!(radius > before)) return angle;
    before = radius;
  }
  return pi;
}

}  // namespace

TEST_CASE("angle limits are where a dense scan finds the first fold or pole") {
  constexpr int steps = 4000;
  for (const std::size_t family : {3, 4, 5}) {
    const Stream stream = make_stream(family, "angle limits");
    int below_pi = 0;
    for (int i = 0; i < 1000; ++i) {
      LensModel lens = random_model(family, stream, i);
      if (auto* unified = std::get_if<UnifiedSpherical>(&lens)) unified->distortion = {};
      const double limit = angle_limit(lens), scanned = first_fold(lens, steps);
      INFO(description(lens) << ": " << limit << ", scanned " << scanned);
      // The scan notices a fold one step late at most.
      REQUIRE(limit <= scanned + 1e-9);
      REQUIRE(limit >= scanned - 2 * pi / steps);
      below_pi += limit < 3.1;
    }
    CHECK(below_pi > 500);
  }
}

TEST_CASE("right below the angle limit a lens still grows; right above it does not") {
  for (const std::size_t family : {3, 4, 5}) {
    const Stream stream = make_stream(family, "about angle limits");
    for (int i = 0; i < 2000; ++i) {
      LensModel lens = random_model(family, stream, i);
      if (auto* unified = std::get_if<UnifiedSpherical>(&lens)) unified->distortion = {};
      const double limit = angle_limit(lens);
      const auto slope = [&](double angle) {
        const ProjectedRay at = project(lens, {std::sin(angle), 0, std::cos(angle)});
        const double slope = at.jacobian.row(0).dot(Eigen::Vector3d(std::cos(angle), 0, -std::sin(angle)));
        return at.point.x() > 0 ? slope : -1;
      };
      INFO(description(lens) << ": " << limit);
      REQUIRE(slope(limit - 1e-5) > 0);
      if (limit < pi - 1e-5) REQUIRE(slope(limit + 1e-5) < 0);
    }
  }
}

TEST_CASE("angle limits in closed form") {
  CHECK(angle_limit(Distortion{}) == pi / 2);
  CHECK(angle_limit(RationalLens{}) == pi / 2);
  CHECK(angle_limit(KannalaBrandt{}) == pi);
  CHECK(angle_limit(UnifiedSpherical{}) == Approx(pi / 2));
  CHECK(angle_limit(UnifiedSpherical{.xi = 0.5}) == Approx(std::acos(-0.5)));
  CHECK(angle_limit(UnifiedSpherical{.xi = 1}) == Approx(pi));
  CHECK(angle_limit(UnifiedSpherical{.xi = 2}) == Approx(std::acos(-0.5)));
  // α = 0 is the pinhole, α = 1, β = 1 the orthographic lens, α = ½, β = 1 the stereographic one.
  CHECK(angle_limit(Eucm{.alpha = 0}) == Approx(pi / 2));
  CHECK(angle_limit(Eucm{.alpha = 1}) == Approx(pi / 2));
  CHECK(angle_limit(Eucm{.alpha = 0.5}) == Approx(pi));
  // Double sphere: α = 0 is the unified sphere with ξ.
  CHECK(angle_limit(DoubleSphere{.xi = 0.3, .alpha = 0}) == Approx(std::acos(-0.3)));
  CHECK(angle_limit(DoubleSphere{.xi = -0.3, .alpha = 0}) == Approx(std::acos(0.3)));
  for (const double alpha : {0.0, 0.3, 0.5, 0.8, 1.0}) {
    CHECK(angle_limit(DoubleSphere{.xi = 0, .alpha = alpha}) == Approx(angle_limit(Eucm{.alpha = alpha})));
    CHECK(angle_limit(DoubleSphere{.xi = 1, .alpha = alpha}) == Approx(pi));
  }
}
