#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/models/warp/model_view.h"
#include "distortion/models/warp/warp_models.h"
#include "numbers/angles.h"
#include "tests/distortion/barrel.h"
#include "tests/distortion/models/family_cameras.h"

using namespace cps;

namespace {

constexpr double sigma_px = 0.5;

ModelCamera centred(const LensModel& lens, int width, int height, double focal) {
  return {"", {width, height, focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)}, lens};
}

/// How many pixels of the output lack a source.
std::int64_t uncovered(const ModelCamera& source, const ModelCamera& output) {
  const OIIO::ImageBuf black(
      OIIO::ImageSpec(source.pinhole.width, source.pinhole.height, 1, OIIO::TypeUInt8));
  WarpSummary summary;
  warp_between(black, source, output,
               {.oversampling = 1,
                .kernel_sigma_px = sigma_px,
                .require_coverage = false,
                .require_resolution = false},
               &summary);
  return summary.uncovered_pixels;
}

ModelCamera straight(const Pinhole& camera, double scale = 1) {
  Pinhole scaled = camera;
  scaled.fx *= scale;
  scaled.fy *= scale;
  return {"", scaled, Distortion{}};
}

}  // namespace

TEST_CASE("seen angles have closed forms") {
  const auto seen = [](const ModelCamera& camera) { return seen_fov(camera, proved_region(camera)).value(); };
  const double diagonal = std::hypot(300, 200);
  for (const double focal : {250.0, 100.0, 60.0}) {  // 83°, 207° and 344° diagonally
    INFO(focal);
    const TrueFov equidistant = seen(centred(KannalaBrandt{}, 300, 200, focal));
    CHECK(equidistant.horizontal_rad == Approx(300 / focal).epsilon(1e-12));
    CHECK(equidistant.vertical_rad == Approx(200 / focal).epsilon(1e-12));
    CHECK(equidistant.diagonal_rad == Approx(diagonal / focal).epsilon(1e-12));
  }
  // The principal point moves both halves, not their sum.
  ModelCamera off_centre = centred(KannalaBrandt{}, 300, 200, 80);
  off_centre.pinhole.cx += 40;
  CHECK(seen(off_centre).horizontal_rad == Approx(300 / 80.0).epsilon(1e-12));
  // Unified with ξ = 1 is stereographic: r = tan(θ/2).
  const TrueFov stereographic = seen(centred(UnifiedSpherical{.xi = 1, .distortion = {}}, 300, 200, 70));
  CHECK(stereographic.horizontal_rad == Approx(4 * std::atan(150 / 70.0)).epsilon(1e-12));
  CHECK(stereographic.vertical_rad == Approx(4 * std::atan(100 / 70.0)).epsilon(1e-12));
  // EUCM with α = 1, β = 1: r = sin θ. With α = 0: a pinhole.
  CHECK(seen(centred(Eucm{.alpha = 1, .beta = 1}, 300, 200, 220)).horizontal_rad ==
        Approx(2 * std::asin(150 / 220.0)).epsilon(1e-12));
  CHECK(seen(centred(Eucm{.alpha = 0, .beta = 1}, 300, 200, 220)).diagonal_rad ==
        Approx(2 * std::atan(diagonal / 440)).epsilon(1e-12));
}

TEST_CASE("a Brown–Conrady camera sees what true_fov says and a narrow region nothing") {
  const Pinhole base = pinhole_from_hfov(300, 200, radians(80));
  const Distortion lens = barrel(base);
  const ModelCamera camera{"", pinhole_from_hfov(300, 200, radians(50)), lens};
  const FrameCertificate proof = certify_frame(lens, camera.pinhole, warpable);
  const auto expected = true_fov(lens, camera.pinhole, proof.rectangle);
  const auto found = seen_fov(camera, proved_region(camera));
  REQUIRE((expected && found));
  CHECK(found->horizontal_rad == expected->horizontal_rad);
  CHECK(found->vertical_rad == expected->vertical_rad);
  CHECK(found->diagonal_rad == expected->diagonal_rad);

  const ModelCamera fisheye = centred(KannalaBrandt{}, 300, 200, 100);
  const double corner = std::hypot(1.5, 1.0);
  CHECK_FALSE(seen_fov(fisheye, {.max_angle_rad = corner - 0.01}));
  CHECK_FALSE(farthest_angle_rad(fisheye, {.max_angle_rad = corner - 0.01}));
  CHECK(seen_fov(fisheye, {.max_angle_rad = corner + 0.01}));
}

TEST_CASE("the farthest angle is that of the farthest corner") {
  ModelCamera camera = centred(KannalaBrandt{}, 300, 200, 100);
  camera.pinhole.cx = 120.5;
  camera.pinhole.cy = 110.5;
  camera.pinhole.fy = 90;
  CHECK(farthest_angle_rad(camera, proved_region(camera)).value() ==
        Approx(std::hypot(1.79, 111 / 90.0)).epsilon(1e-12));
  const ModelCamera pinhole = centred(Distortion{}, 300, 200, 100);
  CHECK(farthest_angle_rad(pinhole, proved_region(pinhole)).value() ==
        Approx(std::atan(std::hypot(1.5, 1.0))).epsilon(1e-12));
}

TEST_CASE("straight views of every family show the widest part without black or everything") {
  for (const ModelCamera& source : family_cameras(120, 90, 75)) {
    INFO(source.name);
    const ViewFit valid = fit_straight_view(source, Keep::valid, 100, 80, sigma_px);
    const ViewFit all = fit_straight_view(source, Keep::all, 100, 80, sigma_px);
    INFO(valid.why << all.why);
    REQUIRE((valid.valid && all.valid));
    CHECK((valid.camera.fx == valid.camera.fy && valid.camera.cx == 49.5 && valid.camera.cy == 39.5));
    CHECK(uncovered(source, straight(valid.camera)) == 0);
    CHECK(uncovered(source, straight(valid.camera, 1 - 1e-3)) > 0);
    // Every pixel corner of the source's rim lies in the frame of `all`, one of them on its rim.
    const RayRegion region = proved_region(source);
    double farthest = 0;
    const auto extend = [&](double x, double y) {
      const Eigen::Vector2d pixel = to_pixel(all.camera, ray_at(source, region, {x, y}).hnormalized());
      farthest = std::max({farthest, std::abs(pixel.x() - 49.5) / 50, std::abs(pixel.y() - 39.5) / 40});
    };
    for (int x = 0; x <= 120; ++x) extend(x - 0.5, -0.5), extend(x - 0.5, 89.5);
    for (int y = 0; y <= 90; ++y) extend(-0.5, y - 0.5), extend(119.5, y - 0.5);
    CHECK(farthest == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("straight views of a Brown–Conrady camera are those of fit_straight_view") {
  const ModelCamera camera = family_cameras(120, 90, 75)[0];
  const CalibratedCamera calibrated{"", camera.pinhole, std::get<Distortion>(camera.lens)};
  for (const Keep keep : {Keep::valid, Keep::all, Keep::camera})
    CHECK(fit_straight_view(camera, keep, 100, 80, sigma_px).camera ==
          fit_straight_view(calibrated, keep, 100, 80, sigma_px).camera);
}

TEST_CASE("a straight view of a fisheye is at most 160 degrees wide") {
  const ModelCamera fisheye = centred(KannalaBrandt{}, 200, 200, 52);  // 220° across
  const ViewFit all = fit_straight_view(fisheye, Keep::all, 100, 80, sigma_px);
  CHECK_FALSE(all.valid);
  CHECK_THAT(all.why, Catch::Contains("155.8") && Catch::Contains("85"));
  const ViewFit valid = fit_straight_view(fisheye, Keep::valid, 100, 80, sigma_px);
  INFO(valid.why);
  REQUIRE(valid.valid);
  CHECK(2 * std::atan(std::hypot(50, 40) / valid.camera.fx) == Approx(radians(160)));
  CHECK(uncovered(fisheye, straight(valid.camera)) == 0);
}

TEST_CASE("the camera's own straight view has the picture's scale in its middle") {
  const ModelCamera unified = centred(UnifiedSpherical{.xi = 1.5, .distortion = {}}, 200, 100, 250);
  const ViewFit same = fit_straight_view(unified, Keep::camera, 200, 100, sigma_px);
  CHECK(same.camera.fx == Approx(100).epsilon(1e-12));
  CHECK(same.camera.cx == unified.pinhole.cx);
  const ViewFit half = fit_straight_view(unified, Keep::camera, 100, 50, sigma_px);
  CHECK(half.camera.fx == Approx(50).epsilon(1e-12));
  CHECK(half.camera.cx == Approx(49.5));
  const ModelCamera fisheye = centred(KannalaBrandt{.k1 = -0.02}, 200, 100, 150);
  CHECK(fit_straight_view(fisheye, Keep::camera, 200, 100, sigma_px).camera == fisheye.pinhole);
}

TEST_CASE("a picture that folds in its frame is straightened where it is one-to-one") {
  const ModelCamera source = centred(KannalaBrandt{.k1 = -0.3}, 100, 100, 50);
  const ViewFit all = fit_straight_view(source, Keep::all, 90, 90, sigma_px);
  REQUIRE(all.valid);
  // θ − .3 θ³ grows up to θ = √(1 / .9), 35 px from the middle; the last pixel corner before it counts.
  const double edge = std::atan(45 / all.camera.fx);
  CHECK((edge > 0.85 && edge < std::sqrt(1 / 0.9)));
  const ViewFit valid = fit_straight_view(source, Keep::valid, 90, 90, sigma_px);
  REQUIRE(valid.valid);
  CHECK(uncovered(source, straight(valid.camera)) == 0);
}

TEST_CASE("a view of any family has no border and less zoom would have one") {
  const auto sources = family_cameras(120, 90, 60), wanted = family_cameras(80, 60, 35);
  int zoomed_in = 0;
  for (const ModelCamera& source : sources)
    for (const ModelCamera& camera : wanted) {
      INFO(source.name << " → " << camera.name);
      const ViewFit fit = fit_distorted_view(source, camera, sigma_px, 10);
      INFO(fit.why);
      REQUIRE(fit.valid);
      const double zoom = fit.camera.fx / camera.pinhole.fx;
      CHECK(fit.camera.fy / camera.pinhole.fy == Approx(zoom).epsilon(1e-12));
      CHECK((fit.camera.cx == camera.pinhole.cx && fit.camera.cy == camera.pinhole.cy));
      ModelCamera view = camera;
      view.pinhole = fit.camera;
      CHECK(uncovered(source, view) == 0);
      if (zoom == 1) continue;
      ++zoomed_in;
      view.pinhole.fx *= 1 - 1e-3;
      view.pinhole.fy *= 1 - 1e-3;
      CHECK(uncovered(source, view) > 0);
      const ViewFit capped = fit_distorted_view(source, camera, sigma_px, 1 + 0.5 * (zoom - 1));
      CHECK_FALSE(capped.valid);
      CHECK_THAT(capped.why, Catch::Contains("zoom") && Catch::Contains("wider source"));
    }
  CHECK(zoomed_in > 10);
}

TEST_CASE("a view of an undistorted source through Brown–Conrady is that of fit_distorted_view") {
  const Pinhole source = pinhole_from_hfov(160, 90, radians(90));
  const ModelCamera wanted = family_cameras(120, 72, 50)[0];
  const CalibratedCamera calibrated{"", wanted.pinhole, std::get<Distortion>(wanted.lens)};
  const ViewFit expected = fit_distorted_view(source, calibrated, sigma_px, 4);
  REQUIRE(expected.valid);
  CHECK(fit_distorted_view(ModelCamera{"", source, Distortion{}}, wanted, sigma_px, 4).camera ==
        expected.camera);
}

TEST_CASE("views refuse lenses that are nowhere one-to-one") {
  ModelCamera broken = family_cameras(80, 60, 35)[2];
  broken.lens = KannalaBrandt{.k1 = std::nan("")};
  const ModelCamera usable = family_cameras(80, 60, 35)[4];
  CHECK_FALSE(fit_straight_view(broken, Keep::valid, 80, 60, sigma_px).valid);
  CHECK_FALSE(fit_distorted_view(broken, usable, sigma_px, 3).valid);
  const ViewFit refused = fit_distorted_view(usable, broken, sigma_px, 3);
  CHECK_FALSE(refused.valid);
  CHECK_THAT(refused.why, Catch::Contains("k1"));
}
