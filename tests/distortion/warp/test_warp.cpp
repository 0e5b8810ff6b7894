#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <vector>

#include "distortion/certificate/certificate.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/crop/crop.h"
#include "distortion/inverse/inverse.h"
#include "distortion/warp/footprints.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/warp.h"
#include "numbers/angles.h"
#include "tests/distortion/barrel.h"
#include "tests/distortion/random_lens.h"
#include "tests/distortion/warp/analytic_scene.h"
#include "tests/distortion/warp/dense_rays.h"
#include "tests/same_bytes.h"

using namespace cps;

namespace {

/// Rings whose frequency grows outwards, up to `highest` cycles per pixel of the base at its corner.
AnalyticScene zone_plate(const Pinhole& base, double highest) {
  const double corner = 0.5 * frame_on_plane(base).diagonal().norm();
  const double rate = std::numbers::pi * highest * base.fx / corner;
  return [=](const Eigen::Vector2d& p) { return float(0.5 + 0.5 * std::cos(rate * p.squaredNorm())); };
}

/// A black and white edge, 5° off the vertical, through the plane's point (x, 0).
AnalyticScene slanted_edge(double x) {
  return [=](const Eigen::Vector2d& p) { return p.x() - x > 0.0875 * p.y() ? 0.9f : 0.1f; };
}

/// Peak signal-to-noise ratio against the reference on every `stride`-th pixel, dB.
double psnr(const AnalyticScene& scene, const Pinhole& base, const Distortion& lens, int stride, int steps) {
  const WarpOptions options;
  const Crop crop = border_free_crop(lens, base, {base.cx + 3.3, base.cy - 2.1});
  INFO(crop.why);
  REQUIRE(crop.valid);
  const Pinhole camera = master_camera(base, options, crop.certificate.min_eigenvalue);
  const OIIO::ImageBuf image = warp(render_analytic(scene, camera, 8), camera, lens, crop.camera, options);
  double squared = 0;
  long count = 0;
  for (int y = 1; y < base.height; y += stride)
    for (int x = 1; x < base.width; x += stride, ++count) {
      const double expected = reference_pixel(scene, lens, frame_on_plane(camera), crop.camera,
                                              options.kernel_sigma_px, {x, y}, steps);
      const double error = image.getchannel(x, y, 0, 0) - expected;
      squared += error * error;
    }
  return -10 * std::log10(squared / count);
}

/// A lens, its crop, and the camera of a master; master() fills one with noise.
struct NoiseWarp {
  Pinhole base = pinhole_from_hfov(200, 120, radians(90));
  Distortion lens = barrel(base);
  WarpOptions options;
  Crop crop = border_free_crop(lens, base, {base.cx, base.cy});
  Pinhole camera = master_camera(base, options, crop.certificate.min_eigenvalue);

  OIIO::ImageBuf master(int channels) const {
    OIIO::ImageBuf image(OIIO::ImageSpec(camera.width, camera.height, channels, OIIO::TypeFloat));
    float* values = static_cast<float*>(image.localpixels());
    for (std::size_t i = 0; i < std::size_t(camera.width) * camera.height * channels; ++i)
      values[i] = float(random_uniform(make_stream(14, "noise"), i));
    return image;
  }
};

}  // namespace

TEST_CASE("the warp agrees with dense rays weighted with its kernel to 40 dB") {
  const Pinhole base = pinhole_from_hfov(160, 100, radians(90));
  const double zone = psnr(zone_plate(base, 0.5), base, barrel(base), 3, 20);
  const double edge = psnr(slanted_edge(0.31), base, barrel(base), 2, 40);
  INFO("zone plate " << zone << " dB, slanted edge " << edge << " dB");
  CHECK(zone > 40);
  CHECK(edge > 40);
}

TEST_CASE("the warp against dense rays at 480 × 270, several lenses", "[slow]") {
  const Pinhole base = pinhole_from_hfov(480, 270, radians(90));
  const double unit = 1 / (0.5 * frame_on_plane(base).diagonal().norm());
  const std::pair<const char*, Distortion> lenses[]{
      {"none", {}},
      {"barrel", barrel(base)},
      {"mild barrel", rescaled({-0.2, 0.05, 0.01, -0.004, 0.003}, unit)},
      {"pincushion", rescaled({0.15, 0.02, -0.01, 0.003, 0.002}, unit)},
      {"moustache", rescaled({-0.25, 0.3, -0.08, 0, 0.004}, unit)}};
  for (const auto& [name, lens] : lenses) {
    const double zone = psnr(zone_plate(base, 0.5), base, lens, 3, 20);
    const double edge = psnr(slanted_edge(0.31), base, lens, 3, 40);
    WARN(name << ": zone plate " << zone << " dB, slanted edge " << edge << " dB");
    CHECK(zone > 40);
    CHECK(edge > 40);
  }
}

TEST_CASE("a constant stays constant and an affine image stays affine") {
  const NoiseWarp w;
  const auto constant = render_analytic([](const Eigen::Vector2d&) { return 0.7f; }, w.camera, 1);
  const auto ramp =
      render_analytic([](const Eigen::Vector2d& p) { return float(2 + p.x() - 0.5 * p.y()); }, w.camera, 1);
  const auto flat = warp(constant, w.camera, {}, w.crop.camera, w.options);
  const auto slope = warp(ramp, w.camera, {}, w.crop.camera, w.options);
  for (int y = 0; y < w.base.height; ++y)
    for (int x = 0; x < w.base.width; ++x) {
      REQUIRE(flat.getchannel(x, y, 0, 0) == Approx(0.7f).epsilon(1e-6));
      const Eigen::Vector2d p = to_plane(w.crop.camera, {x, y});
      // Discrete sums over the kernel leave the mean position within a few thousandths of a pixel.
      REQUIRE(slope.getchannel(x, y, 0, 0) == Approx(2 + p.x() - 0.5 * p.y()).margin(0.01 / w.base.fx));
    }
}

TEST_CASE("the warp gives the same bytes for any number of threads") {
  const NoiseWarp w;
  const auto master = w.master(3);
  std::vector<OIIO::ImageBuf> images;
  for (const int threads : {1, 2, 7}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    images.push_back(warp(master, w.camera, w.lens, w.crop.camera, w.options));
  }
  CHECK(same_bytes(images[0], images[1]));
  CHECK(same_bytes(images[0], images[2]));
}

TEST_CASE("channels and pixel types do not matter") {
  const NoiseWarp w;
  const auto four = warp(w.master(4), w.camera, w.lens, w.crop.camera, w.options);
  for (int channels = 1; channels <= 3; ++channels) {
    OIIO::ImageBuf part(OIIO::ImageSpec(w.camera.width, w.camera.height, channels, OIIO::TypeFloat));
    const auto master = w.master(4);
    for (int y = 0; y < w.camera.height; ++y)
      for (int x = 0; x < w.camera.width; ++x)
        std::memcpy(part.pixeladdr(x, y), master.pixeladdr(x, y), sizeof(float) * channels);
    const auto image = warp(part, w.camera, w.lens, w.crop.camera, w.options);
    for (int c = 0; c < channels; ++c)
      REQUIRE(image.getchannel(50, 60, 0, c) == four.getchannel(50, 60, 0, c));
  }
  const auto reference = warp(w.master(3), w.camera, w.lens, w.crop.camera, w.options);
  for (const auto& [type, tolerance] :
       {std::pair(OIIO::TypeHalf, 1e-3f), std::pair(OIIO::TypeUInt8, 1 / 255.0f)}) {
    const OIIO::ImageBuf converted = w.master(3).copy(type);
    const auto image = warp(converted, w.camera, w.lens, w.crop.camera, w.options);
    CHECK(image.spec().format == type);
    for (int y = 0; y < w.base.height; y += 7)
      for (int x = 0; x < w.base.width; x += 7)
        REQUIRE(std::abs(image.getchannel(x, y, 0, 1) - reference.getchannel(x, y, 0, 1)) <= tolerance);
  }
}

TEST_CASE("the padded master covers every footprint of a border-free crop") {
  const Stream stream = make_stream(15, "coverage");
  const WarpOptions options;
  int warped = 0;
  for (int i = 0; i < 60; ++i) {
    const double hfov = radians(random_uniform(stream, i, 30, 150));
    const Pinhole base = i % 2 ? pinhole_from_hfov(96, 54, hfov) : pinhole_from_hfov(87, 32, hfov);
    const Distortion lens = random_lens(stream, i, base);
    const CertificateOptions certificate;
    const Pinhole camera = master_camera(base, options, certificate.min_eigenvalue);
    const Crop crop = border_free_crop(lens, base, {base.cx + 2, base.cy - 2});
    if (!crop.valid) continue;
    WarpSummary summary;
    OIIO::ImageBuf black(OIIO::ImageSpec(camera.width, camera.height, 1, OIIO::TypeFloat));
    warp(black, camera, lens, crop.camera, options, &summary);
    CHECK(summary.uncovered_pixels == 0);
    CHECK(summary.worst_residual_px < 1e-8);
    ++warped;
  }
  CHECK(warped > 20);
}

TEST_CASE("the crop's cap on magnification is the warp's") {
  CHECK(CropOptions{}.max_magnification <= largest_magnification({}));
  CHECK(CropOptions{}.max_magnification > 0.99 * largest_magnification({}));
}

TEST_CASE("the warp refuses unusable input in one line") {
  const NoiseWarp w;
  const auto master = w.master(1);
  Pinhole wide = w.base, close = w.crop.camera;
  wide.fx = wide.fy = 0.8 * w.base.fx;
  CHECK_THROWS_WITH(warp(master, w.camera, {.k1 = -0.9}, w.crop.camera), Catch::Contains("folds"));
  CHECK_THROWS_WITH(warp(master, w.base, w.lens, w.crop.camera), Catch::Contains("200 x 120"));
  CHECK_THROWS_WITH(warp(master, w.camera, {}, wide), Catch::Contains("beyond"));
  close.fx = close.fy = 5 * w.base.fx;
  CHECK_THROWS_WITH(warp(master, w.camera, w.lens, close), Catch::Contains("oversample"));
  CHECK_THROWS_WITH(warp(master, w.camera, w.lens, w.crop.camera, {.oversampling = 0}),
                    Catch::Contains("oversampling"));
  CHECK_THROWS_WITH(warp(w.master(5), w.camera, w.lens, w.crop.camera), Catch::Contains("channels"));
  CHECK_THROWS_WITH(warp(OIIO::ImageBuf(), w.camera, w.lens, w.crop.camera), Catch::Contains("memory"));
}

TEST_CASE("ids are those of the pixel that the central ray meets") {
  const NoiseWarp w;
  OIIO::ImageBuf ids(OIIO::ImageSpec(w.camera.width, w.camera.height, 1, OIIO::TypeUInt32));
  for (int y = 0; y < w.camera.height; ++y)
    for (int x = 0; x < w.camera.width; ++x)
      *static_cast<std::uint32_t*>(ids.pixeladdr(x, y)) = 4'000'000'000u + y * w.camera.width + x;
  WarpOptions options = w.options;
  options.resampling = Resampling::nearest;
  const auto image = warp(ids, w.camera, w.lens, w.crop.camera, options);
  for (int y = 0; y < w.base.height; ++y)
    for (int x = 0; x < w.base.width; ++x) {
      const auto ideal = undistort(w.lens, frame_on_plane(w.camera), to_plane(w.crop.camera, {x, y}));
      const Eigen::Vector2d at = to_pixel(w.camera, *ideal);
      const std::uint32_t expected = 4'000'000'000u +
                                     std::uint32_t(std::floor(at.y() + 0.5)) * w.camera.width +
                                     std::uint32_t(std::floor(at.x() + 0.5));
      REQUIRE(*static_cast<const std::uint32_t*>(image.pixeladdr(x, y)) == expected);
    }
}

TEST_CASE("depth is exact on planes and never mixed across an edge") {
  const NoiseWarp w;
  // Ground 1.5 m below the camera, with a wall 8 m away on the left and sky above the horizon.
  const auto depth_of_ray = [](const Eigen::Vector2d& ray) {
    if (ray.x() < -0.2) return 8.0;
    return ray.y() > 0.01 ? 1.5 / ray.y() : std::numeric_limits<double>::infinity();
  };
  OIIO::ImageBuf depth(OIIO::ImageSpec(w.camera.width, w.camera.height, 1, OIIO::TypeFloat));
  for (int y = 0; y < w.camera.height; ++y)
    for (int x = 0; x < w.camera.width; ++x)
      *static_cast<float*>(depth.pixeladdr(x, y)) = float(depth_of_ray(to_plane(w.camera, {x, y})));
  WarpOptions options = w.options;
  options.resampling = Resampling::depth;
  const auto image = warp(depth, w.camera, w.lens, w.crop.camera, options);
  int on_ground = 0;
  for (int y = 0; y < w.base.height; ++y)
    for (int x = 0; x < w.base.width; ++x) {
      const auto ray = undistort(w.lens, frame_on_plane(w.camera), to_plane(w.crop.camera, {x, y}));
      const double found = image.getchannel(x, y, 0, 0), expected = depth_of_ray(*ray);
      const double to_edge = std::abs(ray->x() + 0.2);
      if (ray->x() < -0.2 && to_edge > 2 / w.camera.fx) REQUIRE(found == Approx(8));
      if (ray->x() > -0.2 && to_edge > 2 / w.camera.fx && ray->y() > 0.3) {
        ++on_ground;
        REQUIRE(found == Approx(expected).epsilon(1e-5));
      }
      if (to_edge <= 2 / w.camera.fx &&
          ray->y() > 0.3) {  // at the edge: the depth of one side or the other, never between them
        const double share = std::min(std::abs(found / 8 - 1), std::abs(found * ray->y() / 1.5 - 1));
        REQUIRE(share < 0.03);
      }
    }
  CHECK(on_ground > 1000);
}

TEST_CASE("unwarp undoes warp within the kernel's blur") {
  const Pinhole base = pinhole_from_hfov(240, 160, radians(80));
  const Distortion lens = barrel(base);
  const auto scene = [&](const Eigen::Vector2d& p) {
    return float(0.5 + 0.25 * std::sin(base.fx * p.x() / 5) + 0.25 * std::cos(base.fx * p.y() / 4));
  };
  const Crop crop = border_free_crop(lens, base, {base.cx + 4, base.cy - 3});
  REQUIRE(crop.valid);
  const WarpOptions options;
  const Pinhole camera = master_camera(base, options, crop.certificate.min_eigenvalue);
  const auto distorted = warp(render_analytic(scene, camera, 2), camera, lens, crop.camera, options);
  const FrameCertificate proof = certify_frame(lens, crop.camera);
  REQUIRE(proof.valid());
  WarpOptions back{
      .oversampling = 1, .kernel_sigma_px = 0.6, .require_coverage = false, .require_resolution = false};
  WarpSummary summary;
  const auto ideal = unwarp(distorted, crop.camera, lens, base, back, &summary);
  CHECK(summary.uncovered_pixels > 0);
  CHECK(summary.uncovered_pixels < 240 * 160 / 2);
  // The kernels of σ .5 and .6 px damp a wave of angular frequency k by exp(−k²σ²/2) and leave it otherwise
  // unchanged.
  double worst = 0;
  long compared = 0;
  for (int y = 30; y < 130; ++y)
    for (int x = 50; x < 190; ++x) {
      const float found = ideal.getchannel(x, y, 0, 0);
      if (found == 0) continue;
      ++compared;
      worst = std::max(worst, std::abs(double(found) - scene(to_plane(base, {x, y}))));
    }
  CHECK(compared == 100 * 140);
  CHECK(worst < 0.02);
}
