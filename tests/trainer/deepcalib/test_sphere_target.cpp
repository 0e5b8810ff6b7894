#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/warp/seen_hfov.h"
#include "numbers/angles.h"
#include "tests/trainer/deepcalib/sphere_street.h"
#include "trainer/deepcalib/bins.h"
#include "trainer/deepcalib/sphere_target.h"

using namespace cps;

namespace {

ModelCamera sphere(double focal_px, double xi) {
  return {"c", {299, 299, focal_px, focal_px, 149, 149}, UnifiedSpherical{.xi = xi}};
}

}  // namespace

TEST_CASE("a DeepCalib target is where its two numbers lie in their intervals") {
  CHECK(to_sphere_target(sphere(50, 0), "l") == SphereTarget{0, 0});
  CHECK(to_sphere_target(sphere(500, 1.2), "l") == SphereTarget{1, 1});
  const SphereTarget middle = to_sphere_target(sphere(275, .3), "l");
  CHECK(middle.focal == Approx(.5));
  CHECK(middle.xi == Approx(.25));
  // Focal lengths are those of a width of 299 pixels: twice as many pixels, twice the focal length.
  ModelCamera twice{"c", {598, 400, 550, 550, 298.5, 199.5}, UnifiedSpherical{.xi = .3}};
  CHECK(to_sphere_target(twice, "l").focal == Approx(.5));
  // No distortion is ξ = 0.
  twice.lens = Distortion{};
  CHECK(to_sphere_target(twice, "l").xi == 0);
}

TEST_CASE("decoding a target gives back the camera that it was made of") {
  for (std::uint64_t lens = 0; lens < 200; ++lens) {
    const ModelCamera camera = draw_sphere(128, lens);
    const ModelCamera again = to_model_camera(to_sphere_target(camera, "l"), 128, 128);
    CHECK(again.pinhole.fx == Approx(camera.pinhole.fx).epsilon(1e-12));
    CHECK(again.pinhole.fy == again.pinhole.fx);
    CHECK(again.pinhole.cx == camera.pinhole.cx);
    CHECK(again.pinhole.cy == camera.pinhole.cy);
    CHECK(std::get<UnifiedSpherical>(again.lens).xi ==
          Approx(std::get<UnifiedSpherical>(camera.lens).xi).margin(1e-12));
  }
}

TEST_CASE("a camera that two numbers cannot describe is refused in one line") {
  const auto refusal = [](auto change) -> std::string {
    ModelCamera camera = sphere(200, .5);
    change(camera);
    try {
      to_sphere_target(camera, "d/calibration.json");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refusal([](ModelCamera&) {}) == "");
  const std::pair<std::string, std::string> cases[] = {
      {refusal([](ModelCamera& c) { c.lens = Distortion{.k1 = -.1}; }), "model: its lens is brown_conrady"},
      {refusal([](ModelCamera& c) {
         c.lens = Eucm{.6, 1.1};
       }),
       "model: its lens is eucm"},
      {refusal([](ModelCamera& c) {
         c.lens = UnifiedSpherical{.5, {.k1 = .01}};
       }),
       "unified_spherical"},
      {refusal([](ModelCamera& c) { c.pinhole.fy *= 1.01; }), "not square"},
      {refusal([](ModelCamera& c) { c.pinhole.cx += 2; }), "not the image's middle"},
      {refusal([](ModelCamera& c) { c.pinhole.fx = c.pinhole.fy = 501; }), "501"},
      {refusal([](ModelCamera& c) { c.lens = UnifiedSpherical{.xi = 1.3}; }), "xi, 1.3"}};
  for (const auto& [line, reason] : cases) {
    CHECK_THAT(
        line, Catch::StartsWith("d/calibration.json: ") && Catch::Contains(reason) && !Catch::Contains("\n"));
  }
}

TEST_CASE("the H-FOV that a target sees is that of its camera") {
  for (std::uint64_t lens = 0; lens < 100; ++lens) {
    const ModelCamera camera = draw_sphere(96, lens);
    const auto seen = seen_hfov_rad(camera, certify_frame(camera).region);
    REQUIRE(seen);
    CHECK(seen_hfov_rad(to_sphere_target(camera, "l"), 96) == Approx(*seen).epsilon(1e-7));
  }
  // ξ = 0: a pinhole. Above ξ = 1 the angle ends at arccos(−1/ξ): a row wider than that sees no more.
  CHECK(seen_hfov_rad({(149.5 - 50) / 450, 0}, 299) == Approx(radians(90)));
  CHECK(seen_hfov_rad({0, 1}, 299) == Approx(2 * std::acos(-1 / 1.2)).epsilon(1e-4));
}

TEST_CASE("means and deviations of targets in closed form") {
  const std::vector<SphereTarget> targets{{0, .4}, {1, .4}, {.5, .4}};
  const SphereStatistics fit = sphere_statistics(targets);
  CHECK(fit.mean.focal == Approx(.5));
  CHECK(fit.mean.xi == Approx(.4));
  CHECK(fit.deviation.focal == Approx(std::sqrt(.5 / 3)));
  CHECK(fit.deviation.xi == 1);
}

TEST_CASE("every share belongs to the nearest bin and a border to the upper one") {
  // 46 focal lengths from 50 to 500 in steps of 10, and 61 values of ξ in steps of .02.
  for (int bin = 0; bin < focal_bins; ++bin) {
    const double focal_px = 50 + 10 * bin;
    CHECK(50 + 450 * bin_share(bin, focal_bins) == Approx(focal_px));
    CHECK(nearest_bin((focal_px - 50) / 450, focal_bins) == bin);
    CHECK(nearest_bin(std::min(1., (focal_px + 4.999 - 50) / 450), focal_bins) == bin);
    CHECK(nearest_bin(std::max(0., (focal_px - 4.999 - 50) / 450), focal_bins) == bin);
  }
  for (int bin = 0; bin < xi_bins; ++bin) CHECK(nearest_bin(bin * .02 / 1.2, xi_bins) == bin);
  // 5 bins have borders that are exact in binary: 1/8, 3/8, …
  for (int bin = 1; bin < 5; ++bin) {
    const double border = (bin - .5) / 4;
    CHECK(nearest_bin(border, 5) == bin);
    CHECK(nearest_bin(std::nextafter(border, 0.), 5) == bin - 1);
  }
  CHECK(nearest_bin(0, 5) == 0);
  CHECK(nearest_bin(1, 5) == 4);
}
