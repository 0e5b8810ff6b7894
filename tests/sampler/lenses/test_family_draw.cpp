#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/projection.h"
#include "numbers/angles.h"
#include "sampler/lenses/family_draw.h"
#include "sampler/lenses/model_prior.h"
#include "tests/sampler/lenses/kolmogorov.h"

using namespace cps;

namespace {

constexpr ImageSize small_frame{96, 72};

/// A ray in the plane of the middle row.
Eigen::Vector3d row_ray(double angle_rad) {
  return {std::sin(angle_rad), 0, std::cos(angle_rad)};
}

}  // namespace

TEST_CASE("a drawn lens shows the H-FOV along a middle row that grows with the angle and is proved") {
  const Stream stream = make_stream(5, "family draw");
  for (const std::string_view family : prior_families())
    for (const double hfov_deg : {20.0, 100.0, 160.0, 195.0})
      for (int i = 0; i < 10; ++i) {
        const double half = radians(hfov_deg) / 2;
        const ModelCamera camera = draw_family_camera(family, small_frame, 2 * half, substream(stream, i));
        REQUIRE(family_name(camera.lens) == family);
        REQUIRE(camera.pinhole.fx == camera.pinhole.fy);
        REQUIRE(camera.pinhole.cx == 47.5);
        REQUIRE(camera.pinhole.cy == 35.5);
        // The families are radially symmetric: half of the angle lies on each side.
        REQUIRE(to_pixel(camera.pinhole, project(camera.lens, row_ray(half)).point).x() ==
                Approx(95.5).margin(1e-6));
        const RayRegion region = certify_frame(camera, one_to_one).region;
        double last = -1;
        for (int step = 0; step <= 200; ++step) {
          const Eigen::Vector3d ray = row_ray(half * (1 - 1e-9) * step / 200);
          REQUIRE(contains(region, camera.lens, ray));
          const double x = project(camera.lens, ray).point.x();
          REQUIRE(x > last);
          last = x;
        }
      }
}

TEST_CASE("the first lens of the prior is taken where it shows the H-FOV") {
  // Every kannala_brandt lens of the prior shows 60 degrees, and none is coarse in its middle.
  const Stream stream = make_stream(6, "family draw");
  for (int i = 0; i < 60; ++i) {
    const Stream of_lens = substream(stream, i);
    CHECK(draw_family_camera("kannala_brandt", small_frame, radians(60), of_lens).lens ==
          draw_model_lens("kannala_brandt", substream(of_lens, 0)));
  }
}

TEST_CASE("of wide unified lenses those are left whose middle is fine enough and as they are in the prior") {
  // With the half angle a, a row is (W/2) (cos a + xi) / sin a · 1 / (1 + xi) pixels per radian fine in its
  // middle, and W / 2a in the mean: a third of that is reached at this xi, below which lenses are rejected.
  const double half = radians(195) / 2;
  const double a = std::cos(half) - std::sin(half) / (3 * half), b = 1 - std::sin(half) / (3 * half);
  const double smallest_xi = -a / b;
  REQUIRE(smallest_xi > 0.3);
  REQUIRE(smallest_xi < 0.5);
  const Stream stream = make_stream(7, "family draw");
  std::vector<double> xis;
  int first_taken = 0;
  constexpr int draws = 400;
  for (int i = 0; i < draws; ++i) {
    const Stream of_lens = substream(stream, i);
    const LensModel lens = draw_family_camera("unified_spherical", small_frame, 2 * half, of_lens).lens;
    xis.push_back(std::get<UnifiedSpherical>(lens).xi);
    CHECK(xis.back() >= smallest_xi - 1e-9);
    first_taken += lens == draw_model_lens("unified_spherical", substream(of_lens, 0));
  }
  CHECK(kolmogorov(xis, [&](double xi) { return uniform_cdf(xi, smallest_xi, 1.2); }) < one_in_a_thousand);
  const double share = (1.2 - smallest_xi) / 1.2;
  CHECK(std::abs(first_taken - share * draws) < 4 * std::sqrt(share * (1 - share) * draws));
}

TEST_CASE("an H-FOV that no lens of the family shows is refused", "[slow]") {
  CHECK_THROWS_WITH(draw_family_camera("eucm", small_frame, radians(359), make_stream(1, "")),
                    Catch::StartsWith("no eucm lens found in 1000 attempts that shows 359 degrees"));
}

TEST_CASE("a family without a prior is refused where a lens is drawn") {
  CHECK_THROWS_WITH(draw_family_camera("rational", small_frame, radians(90), make_stream(1, "")),
                    Catch::Contains("rational") && Catch::Contains("kannala_brandt"));
}
