#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/models/projection.h"
#include "distortion/models/warp/model_view.h"
#include "distortion/models/warp/warp_models.h"
#include "numbers/angles.h"
#include "random/counter_hash.h"
#include "tests/distortion/barrel.h"
#include "tests/distortion/models/family_cameras.h"
#include "tests/distortion/warp/slow_warp.h"
#include "tests/same_bytes.h"

using namespace cps;

namespace {

/// Bare of all requirements.
const WarpOptions lenient{.require_coverage = false, .require_resolution = false};

OIIO::ImageBuf noise(const Pinhole& camera, int channels) {
  OIIO::ImageBuf image(OIIO::ImageSpec(camera.width, camera.height, channels, OIIO::TypeFloat));
  float* values = static_cast<float*>(image.localpixels());
  for (std::size_t i = 0; i < image.spec().image_pixels() * channels; ++i)
    values[i] = float(random_uniform(make_stream(51, "warp models"), i));
  return image;
}

OIIO::ImageBuf white(const Pinhole& camera) {
  OIIO::ImageBuf image(OIIO::ImageSpec(camera.width, camera.height, 1, OIIO::TypeFloat));
  std::fill_n(static_cast<float*>(image.localpixels()), image.spec().image_pixels(), 1.0f);
  return image;
}

double largest_difference(const OIIO::ImageBuf& a, const OIIO::ImageBuf& b) {
  REQUIRE(a.spec().image_bytes() == b.spec().image_bytes());
  const float *first = static_cast<const float*>(a.localpixels()),
              *second = static_cast<const float*>(b.localpixels());
  double largest = 0;
  for (std::size_t i = 0; i < a.spec().image_pixels() * a.nchannels(); ++i)
    largest = std::max(largest, std::abs(double(first[i]) - second[i]));
  return largest;
}

/// Weights and sums are floats: means of values up to 1 over some fifty pixels agree to several times 2⁻²⁴
/// where the footprints agree to 1e-9 px.
constexpr double float_rounding = 2e-6;

bool is_valid(const OIIO::ImageBuf& mask, int x, int y) {
  return *static_cast<const std::uint8_t*>(mask.pixeladdr(x, y)) == 255;
}

}  // namespace

TEST_CASE("between Brown–Conrady cameras the warp of any two families is warp and unwarp") {
  const Pinhole base = pinhole_from_hfov(120, 80, radians(85)), master = oversampled(base, 2, 24);
  Pinhole output = base;
  output.fx *= 1.5;
  output.fy *= 1.52;
  output.cx += 3;
  const Distortion lens = barrel(base);
  const auto picture = noise(master, 3);
  WarpSummary expected, found;
  CHECK(largest_difference(warp(picture, master, lens, output, lenient, &expected),
                           warp_between(picture, {"", master, Distortion{}}, {"", output, lens}, lenient,
                                        &found)) < float_rounding);
  CHECK(found.uncovered_pixels == expected.uncovered_pixels);
  CHECK(found.smallest_kernel_sigma_px == Approx(expected.smallest_kernel_sigma_px).epsilon(1e-5));
  CHECK(found.worst_residual_px < 1e-8);

  const Pinhole straight = oversampled(base, 1, 10);
  const auto seen = noise(output, 2);
  CHECK(largest_difference(unwarp(seen, output, lens, straight, lenient, &expected),
                           warp_between(seen, {"", output, lens}, {"", straight, Distortion{}}, lenient,
                                        &found)) < float_rounding);
  CHECK(expected.uncovered_pixels > 1000);
  CHECK(found.uncovered_pixels == expected.uncovered_pixels);
}

TEST_CASE("a family that contains another gives its pictures") {
  const Pinhole pinhole{100, 70, 60, 61, 48, 36}, wide{260, 200, 90, 91, 131, 98};
  const Distortion lens{.k1 = -0.15, .k2 = 0.03, .p1 = 0.001, .p2 = -0.002};
  const RationalLens rational{.k1 = lens.k1, .k2 = lens.k2, .p1 = lens.p1, .p2 = lens.p2};
  const auto picture = noise(wide, 1);
  const auto seen_by = [&](const LensModel& of_source, const LensModel& of_output) {
    return warp_between(picture, {"", wide, of_source}, {"", pinhole, of_output}, lenient);
  };
  const auto curved = seen_by(Distortion{}, lens), straight = seen_by(lens, Distortion{});
  for (const LensModel& same : {LensModel(rational), LensModel(UnifiedSpherical{0, lens})}) {
    INFO(family_name(same));
    CHECK(largest_difference(curved, seen_by(Distortion{}, same)) < float_rounding);
    CHECK(largest_difference(straight, seen_by(same, Distortion{})) < float_rounding);
  }
  const auto copied = seen_by(Distortion{}, Distortion{});
  for (const LensModel& same : {LensModel(Eucm{0, 1}), LensModel(DoubleSphere{0, 0})}) {
    INFO(family_name(same));
    CHECK(largest_difference(copied, seen_by(Distortion{}, same)) < float_rounding);
    CHECK(largest_difference(copied, seen_by(same, Distortion{})) < float_rounding);
  }
}

TEST_CASE("a picture of any family becomes the picture of any other") {
  const auto sources = family_cameras(220, 170, 110), outputs = family_cameras(64, 48, 55);
  for (const ModelCamera& source : sources) {
    const OIIO::ImageBuf picture = photograph_scene(source);
    for (const ModelCamera& output : outputs) {
      INFO(source.name << " → " << output.name);
      WarpOptions options;
      options.require_resolution = false;
      WarpSummary summary;
      const auto image = warp_between(picture, source, output, options, &summary);
      CHECK(summary.worst_residual_px < 1e-8);
      // The kernel's variance of .25 px² blurs the scene by at most ½ · .25 · 5 / 55² = .0002, twice that in
      // the corners, where a pixel sees more; sums over pixels leave its mean position within .01 source
      // pixels, .0001. A footprint that is .05 output pixels off adds .001.
      CHECK(largest_difference(image, photograph_scene(output)) < 6e-4);
    }
  }
}

TEST_CASE("a fisheye picture survives being straightened and bent back") {
  const ModelCamera fisheye = family_camera(KannalaBrandt{.k1 = 0.01, .k2 = -0.004}, 160, 120, 85);
  const OIIO::ImageBuf picture = photograph_scene(fisheye);
  const ViewFit fit = fit_straight_view(fisheye, Keep::all, 520, 400, 0.5);
  INFO(fit.why);
  REQUIRE(fit.valid);
  const ModelCamera straight{"", fit.camera, Distortion{}};
  const auto straightened = warp_between(picture, fisheye, straight, lenient);
  const auto back = warp_between(straightened, straight, fisheye, lenient);
  const auto mask = valid_pixels(fisheye, straight);
  const RayRegion region = proved_region(fisheye);
  // Whether the way back sees no pixel of the straight picture's black border: its kernel reaches √10 · .5
  // fisheye pixels, each of which is enlarged by up to 1 / cos² of its angle.
  const auto is_inside = [&](int x, int y) {
    const Eigen::Vector3d ray = ray_at(fisheye, region, {x, y});
    const Eigen::Vector2d at = to_pixel(fit.camera, ray.hnormalized());
    const double enlarged = fit.camera.fx / fisheye.pinhole.fx / (ray.z() * ray.z());
    const int reach = int(std::ceil(0.5 * kernel_support * enlarged)) + 2;
    for (const int dx : {-reach, reach})
      for (const int dy : {-reach, reach}) {
        const int px = int(std::lround(at.x())) + dx, py = int(std::lround(at.y())) + dy;
        if (px < 0 || py < 0 || px >= fit.camera.width || py >= fit.camera.height) return false;
        if (!is_valid(mask, px, py)) return false;
      }
    return true;
  };
  int compared = 0;
  double worst = 0;
  for (int y = 0; y < 120; y += 2)
    for (int x = 0; x < 160; x += 2) {
      if (!is_inside(x, y)) continue;
      ++compared;
      worst = std::max(worst, std::abs(double(back.getchannel(x, y, 0, 0)) - picture.getchannel(x, y, 0, 0)));
    }
  CHECK(compared > 80 * 60 * 0.7);
  // Two kernels of half a fisheye pixel's standard deviation: 2 · ½ · .25 · 5 / 85² = .0002; the narrow one
  // of the way there, where the picture is enlarged, moves the scene by some .01 px, .0002, on top.
  CHECK(worst < 8e-4);
}

TEST_CASE("valid pixels are those whose whole footprint lies in the source") {
  const ModelCamera source = family_camera(KannalaBrandt{.k1 = -0.02}, 160, 120, 70);
  const RayRegion source_region = proved_region(source);
  for (const LensModel& lens :
       {LensModel(Distortion{}), LensModel(UnifiedSpherical{1.2, {}}), LensModel(DoubleSphere{-0.2, 0.52})}) {
    const ModelCamera output = family_camera(lens, 130, 100, 34);
    INFO(output.name);
    const RayRegion region = proved_region(output);
    const OIIO::ImageBuf mask = valid_pixels(source, output);
    CHECK((mask.spec().format == OIIO::TypeUInt8 && mask.nchannels() == 1));

    // Where the source shows what the output shows at a position; NaN where it shows nothing.
    const auto seen_at = [&](double x, double y) -> Eigen::Vector2d {
      const Eigen::Vector3d ray = ray_at(output, region, {x, y});
      if (!contains(source_region, source.lens, ray)) return Eigen::Vector2d::Constant(std::nan(""));
      return to_pixel(source.pinhole, project(source.lens, ray).point);
    };
    int valid = 0, invalid = 0, doubtful = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 130; ++x) {
        const double step = 1e-3;
        Eigen::Matrix2d jacobian;
        jacobian << (seen_at(x + step, y) - seen_at(x - step, y)) / (2 * step),
            (seen_at(x, y + step) - seen_at(x, y - step)) / (2 * step);
        const Eigen::Vector2d at = seen_at(x, y);
        const Eigen::Vector2d reach = kernel_support * slow_covariance(jacobian, 0.5).diagonal().cwiseSqrt();
        // No pixel centre of the kernel's box lies beyond the first and last ones.
        const double margin = std::min({at.x() - reach.x() + 1, at.y() - reach.y() + 1,
                                        160 - at.x() - reach.x(), 120 - at.y() - reach.y()});
        const bool expected = margin > 0;
        (expected ? valid : invalid) += 1;
        if (std::abs(margin) < 1e-3)
          ++doubtful;
        else
          REQUIRE(is_valid(mask, x, y) == expected);
      }
    CHECK((valid > 1000 && invalid > 1000 && doubtful < 20));

    WarpSummary summary;
    const auto image = warp_between(white(source.pinhole), source, output, lenient, &summary);
    std::int64_t black = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 130; ++x) {
        black += !is_valid(mask, x, y);
        REQUIRE(image.getchannel(x, y, 0, 0) == Approx(is_valid(mask, x, y) ? 1 : 0).margin(1e-6));
      }
    CHECK(summary.uncovered_pixels == black);
  }
}

TEST_CASE("rays beside and behind a plane camera meet none of its pixels") {
  const ModelCamera source{"", pinhole_from_hfov(120, 120, radians(120)), Distortion{}};
  const ModelCamera output = family_camera(KannalaBrandt{}, 160, 160, 42);
  const RayRegion region = proved_region(output);
  const auto mask = valid_pixels(source, output);
  const auto image = warp_between(white(source.pinhole), source, output, lenient);
  int behind = 0, seen = 0;
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      const Eigen::Vector3d ray = ray_at(output, region, {x, y});
      const bool is_in_frame = ray.z() > 0 && frame_on_plane(source.pinhole).contains(ray.hnormalized());
      if (!is_in_frame) REQUIRE((image.getchannel(x, y, 0, 0) == 0 && !is_valid(mask, x, y)));
      behind += ray.z() <= 0;
      seen += is_valid(mask, x, y);
    }
  CHECK(behind > 5000);
  CHECK(seen > 3000);
}

TEST_CASE("a lens that folds in its frame is used where it is proved") {
  // θ − .3 θ³ grows up to θ = √(1 / .9) = 1.054, radius .703; the frame reaches 1.0.
  const ModelCamera source{"", {100, 100, 50, 50, 49.5, 49.5}, KannalaBrandt{.k1 = -0.3}};
  REQUIRE_FALSE(certify_frame(source).valid);
  const ModelCamera output{"", {60, 60, 20, 20, 29.5, 29.5}, Distortion{}};
  const auto image = warp_between(white(source.pinhole), source, output, lenient);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) {
      const double angle = std::atan(to_plane(output.pinhole, {x, y}).norm());
      INFO(angle);
      if (angle < 1.05) REQUIRE(image.getchannel(x, y, 0, 0) == Approx(1));
      if (angle > 1.06) REQUIRE(image.getchannel(x, y, 0, 0) == 0);
    }
}

TEST_CASE("the warp of any two families gives the same bytes for any number of threads") {
  const ModelCamera source = family_cameras(220, 170, 110)[3], output = family_cameras(150, 130, 60)[5];
  const auto picture = noise(source.pinhole, 3);
  std::vector<OIIO::ImageBuf> images, masks;
  for (const int threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    images.push_back(warp_between(picture, source, output, lenient));
    masks.push_back(valid_pixels(source, output));
  }
  for (const int i : {1, 2}) {
    CHECK(same_bytes(images[0], images[i]));
    CHECK(same_bytes(masks[0], masks[i]));
  }
}

TEST_CASE("the warp of any two families refuses unusable input in one line") {
  const ModelCamera source = family_camera(KannalaBrandt{}, 100, 80, 50);
  const ModelCamera output = family_camera(Distortion{}, 60, 40, 60);
  const auto picture = noise(source.pinhole, 1);
  CHECK_THROWS_WITH(warp_between(picture, output, source), Catch::Contains("100 x 80"));
  CHECK_THROWS_WITH(warp_between(noise(source.pinhole, 5), source, output), Catch::Contains("channels"));
  CHECK_THROWS_WITH(warp_between(OIIO::ImageBuf(), source, output), Catch::Contains("memory"));
  CHECK_THROWS_WITH(warp_between(picture, source, output, {.oversampling = 0}),
                    Catch::Contains("oversampling"));
  CHECK_THROWS_WITH(valid_pixels(source, output, {.kernel_sigma_px = 0}), Catch::Contains("kernel_sigma_px"));
  CHECK_THROWS_WITH(warp_between(picture, source, family_camera(Distortion{}, 60, 40, 15)),
                    Catch::Contains("beyond"));
  CHECK_THROWS_WITH(warp_between(picture, source, family_camera(Distortion{}, 60, 40, 300)),
                    Catch::Contains("oversample"));
  ModelCamera broken = source;
  broken.lens = KannalaBrandt{.k1 = std::nan("")};
  CHECK_THROWS_WITH(warp_between(picture, broken, output), Catch::Contains("k1"));
  CHECK_THROWS_AS(valid_pixels(broken, output), std::runtime_error);
}
