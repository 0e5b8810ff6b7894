#include <catch2/catch.hpp>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/warp/view_fit.h"
#include "distortion/warp/warp.h"
#include "numbers/angles.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

namespace {

constexpr double sigma_px = 0.5;

/// Warps a black picture and returns how many pixels of the output lack a source.
std::int64_t uncovered(const Pinhole& source, const Distortion& lens, const Pinhole& output) {
  const OIIO::ImageBuf black(OIIO::ImageSpec(source.width, source.height, 1, OIIO::TypeUInt8));
  WarpSummary summary;
  warp(black, source, lens, output,
       {.oversampling = 1,
        .kernel_sigma_px = sigma_px,
        .require_coverage = false,
        .require_resolution = false},
       &summary);
  return summary.uncovered_pixels;
}

/// Pixels without a source, or beyond the lens' fold, which warp() refuses.
bool has_border(const Pinhole& source, const Distortion& lens, const Pinhole& output) {
  try {
    return uncovered(source, lens, output) > 0;
  } catch (const std::runtime_error&) {
    return true;
  }
}

std::int64_t uncovered_straight(const CalibratedCamera& source, const Pinhole& output) {
  const OIIO::ImageBuf black(
      OIIO::ImageSpec(source.pinhole.width, source.pinhole.height, 1, OIIO::TypeUInt8));
  WarpSummary summary;
  unwarp(black, source.pinhole, source.distortion, output,
         {.oversampling = 1,
          .kernel_sigma_px = sigma_px,
          .require_coverage = false,
          .require_resolution = false},
         &summary);
  return summary.uncovered_pixels;
}

Pinhole scaled(const Pinhole& camera, double scale) {
  Pinhole result = camera;
  result.fx *= scale;
  result.fy *= scale;
  return result;
}

}  // namespace

TEST_CASE("a distorted view has no border, and less zoom would have one") {
  const Stream stream = make_stream(31, "view fit");
  int fitted = 0;
  for (int i = 0; i < 40; ++i) {
    const double hfov = radians(random_uniform(stream, i, 40, 140));
    const Pinhole source = pinhole_from_hfov(160, 90, hfov);
    CalibratedCamera wanted{"", pinhole_from_hfov(120, 72, hfov), random_lens(stream, i, source)};
    wanted.pinhole.cx += 3.2;
    wanted.pinhole.fy *= 1.01;
    const ViewFit fit = fit_distorted_view(source, wanted, sigma_px, 4);
    if (!fit.valid) continue;
    ++fitted;
    CHECK(fit.camera.fx / wanted.pinhole.fx == Approx(fit.camera.fy / wanted.pinhole.fy).epsilon(1e-12));
    CHECK(uncovered(source, wanted.distortion, fit.camera) == 0);
    if (fit.camera.fx > wanted.pinhole.fx)
      CHECK(has_border(source, wanted.distortion, scaled(fit.camera, 1 - 1e-3)));
  }
  CHECK(fitted > 20);
}

TEST_CASE("a source that shows enough gives the wanted camera itself") {
  const Pinhole source = pinhole_from_hfov(320, 200, radians(120));
  const CalibratedCamera wanted{"", {160, 90, 110, 111, 81.5, 43.25}, {.k1 = -0.2, .k2 = 0.03, .p1 = 0.001}};
  const ViewFit fit = fit_distorted_view(source, wanted, sigma_px, 1);
  INFO(fit.why);
  REQUIRE(fit.valid);
  CHECK(fit.camera == wanted.pinhole);
  const ViewFit refused = fit_distorted_view(pinhole_from_hfov(320, 200, radians(60)), wanted, sigma_px, 1);
  CHECK_FALSE(refused.valid);
  CHECK_THAT(refused.why, Catch::Contains("zoom") && Catch::Contains("wider source"));
  CHECK_FALSE(fit_distorted_view(source, {"", wanted.pinhole, {.k1 = std::nan("")}}, sigma_px, 3).valid);
}

TEST_CASE("straight views: the widest without black, everything, and the camera's own") {
  const Stream stream = make_stream(32, "straight view");
  int fitted = 0, whole = 0;
  for (int i = 0; i < 30; ++i) {
    CalibratedCamera source{"", pinhole_from_hfov(120, 72, radians(random_uniform(stream, i, 30, 110))), {}};
    source.distortion = random_lens(stream, i, source.pinhole);
    source.pinhole.cx -= 4;
    source.pinhole.fx *= 0.99;
    const ViewFit valid = fit_straight_view(source, Keep::valid, 100, 80, sigma_px);
    const ViewFit all = fit_straight_view(source, Keep::all, 100, 80, sigma_px);
    if (!valid.valid || !all.valid) continue;
    const FrameCertificate proof = certify_frame(source.distortion, source.pinhole, warpable);
    ++fitted;
    CHECK((valid.camera.fx == valid.camera.fy && valid.camera.cx == 49.5 && valid.camera.cy == 39.5));
    CHECK(uncovered_straight(source, valid.camera) == 0);
    CHECK(uncovered_straight(source, scaled(valid.camera, 1 - 1e-3)) > 0);
    CHECK(all.camera.fx <= valid.camera.fx);
    // Every corner of a source pixel on the source's rim lies in the frame; if the lens is certified on the
    // whole source, one of them lies on the frame's rim.
    double farthest = 0;
    const auto extend = [&](double x, double y) {
      const auto ideal = undistort(source.distortion, proof.rectangle, to_plane(source.pinhole, {x, y}));
      if (!ideal) return;
      const Eigen::Vector2d pixel = to_pixel(all.camera, *ideal);
      farthest = std::max({farthest, std::abs(pixel.x() - 49.5) / 50, std::abs(pixel.y() - 39.5) / 40});
    };
    for (int x = 0; x <= 120; ++x) extend(x - 0.5, -0.5), extend(x - 0.5, 71.5);
    for (int y = 0; y <= 72; ++y) extend(-0.5, y - 0.5), extend(119.5, y - 0.5);
    CHECK(farthest <= 1 + 1e-9);
    whole += proof.valid();
    if (proof.valid()) CHECK(farthest >= 1 - 1e-9);
  }
  CHECK(fitted > 15);
  CHECK(whole > 5);
  const CalibratedCamera camera{"", {120, 72, 100, 101, 60, 30}, {.k1 = -0.1}};
  CHECK(fit_straight_view(camera, Keep::camera, 120, 72, sigma_px).camera == camera.pinhole);
  CHECK_FALSE(
      fit_straight_view(CalibratedCamera{"", {120, 72, 0, 101, 60, 30}, {}}, Keep::all, 120, 72, sigma_px)
          .valid);
}
