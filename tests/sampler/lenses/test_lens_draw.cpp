#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "distortion/certificate/certificate.h"
#include "distortion/certificate/displacement.h"
#include "numbers/angles.h"
#include "sampler/lenses/lens_draw.h"

using namespace cps;

TEST_CASE("every drawn lens is certified on its base, within its limits and its crop's caps") {
  for (LensScheme scheme : {LensScheme::sequential, LensScheme::shape_prior, LensScheme::real_lenses})
    for (double hfov_deg : {30.0, 90.0, 150.0})
      for (int i = 0; i < 40; ++i) {
        const LensOptions options{
            .scheme = scheme, .sequential_share = 0, .bounds = {}, .principal_point = {}};
        const Pinhole base = pinhole_from_hfov(i % 2 ? 480 : 348, i % 2 ? 270 : 128, radians(hfov_deg));
        const DrawnLens lens =
            draw_lens(base, CropOrder::base_first, options, substream(make_stream(0, "lens"), i));
        CHECK(certify(lens.distortion, frame_on_plane(base)).valid);
        CHECK(largest_displacement(lens.distortion, frame_on_plane(base)) <=
              options.bounds.max_displacement * (1 + 1e-9));
        CHECK(lens.crop.valid);
        CHECK(lens.crop.zoom >= 1);
        CHECK(lens.crop.zoom <= options.principal_point.max_zoom);
        const double values[7] = {lens.distortion.k1, lens.distortion.k2, lens.distortion.k3,
                                  lens.distortion.p1, lens.distortion.p2, lens.crop.camera.cx,
                                  lens.crop.camera.cy};
        for (int k = 0; k < 7; ++k) {
          REQUIRE(lens.limits[k].has_value() == (scheme == LensScheme::sequential || k >= 5));
          if (!lens.limits[k]) continue;
          CHECK(values[k] >= lens.limits[k]->low);
          CHECK(values[k] <= lens.limits[k]->high);
        }
        CHECK(std::abs(lens.crop.camera.cx - base.cx) <= 0.03 * base.width);
        CHECK(std::abs(lens.crop.camera.cy - base.cy) <= 0.08 * base.height);
      }
}

TEST_CASE("label-first, the label's H-FOV is the one asked for and each lens has the base that leads there") {
  for (LensScheme scheme : {LensScheme::sequential, LensScheme::shape_prior, LensScheme::real_lenses})
    for (double hfov_deg : {30.0, 90.0, 140.0})
      for (int i = 0; i < 20; ++i) {
        const LensOptions options{
            .scheme = scheme, .sequential_share = 0, .bounds = {}, .principal_point = {}};
        const Pinhole wanted = pinhole_from_hfov(348, 128, radians(hfov_deg));
        const DrawnLens lens =
            draw_lens(wanted, CropOrder::label_first, options, substream(make_stream(3, "lens"), i));
        CHECK(lens.crop.valid);
        CHECK(degrees(hfov_rad(lens.crop.camera)) == Approx(hfov_deg).epsilon(1e-9));
        CHECK(lens.base.fx * lens.crop.zoom == Approx(wanted.fx).epsilon(1e-9));
        CHECK(is_within(options.bounds, lens.distortion, frame_on_plane(lens.base)));
        const double values[] = {lens.distortion.k1, lens.distortion.k2, lens.distortion.k3,
                                 lens.distortion.p1, lens.distortion.p2};
        for (int k = 0; k < 5; ++k)
          if (lens.limits[k]) {
            CHECK(values[k] >= lens.limits[k]->low);
            CHECK(values[k] <= lens.limits[k]->high);
          }
      }
}

TEST_CASE("the crop's order changes what is rendered, not the lens relative to it") {
  for (int i = 0; i < 20; ++i) {
    const LensOptions options{
        .scheme = LensScheme::shape_prior, .sequential_share = 0.5, .bounds = {}, .principal_point = {}};
    const Pinhole camera = pinhole_from_hfov(480, 270, radians(80));
    const Stream stream = substream(make_stream(4, "lens"), i);
    const DrawnLens base_first = draw_lens(camera, CropOrder::base_first, options, stream);
    const DrawnLens label_first = draw_lens(camera, CropOrder::label_first, options, stream);
    const auto scaled = [](const DrawnLens& lens) {
      return rescaled(lens.distortion, 0.5 * frame_on_plane(lens.base).diagonal().norm());
    };
    CHECK(scaled(base_first).k1 == Approx(scaled(label_first).k1));
    CHECK(scaled(base_first).p2 == Approx(scaled(label_first).p2));
    CHECK(base_first.crop.zoom == Approx(label_first.crop.zoom).epsilon(1e-9));
    CHECK(base_first.crop.camera.cy == Approx(label_first.crop.camera.cy));
  }
}

TEST_CASE("but for the real lenses, a lens knows nothing of the H-FOV, or of the number of pixels") {
  for (LensScheme scheme : {LensScheme::sequential, LensScheme::shape_prior})
    for (int i = 0; i < 20; ++i) {
      const LensOptions options{.scheme = scheme, .sequential_share = 0, .bounds = {}, .principal_point = {}};
      const Stream stream = substream(make_stream(6, "lens"), i);
      const auto scaled = [&](int size, double hfov_deg) {
        const Pinhole base = pinhole_from_hfov(16 * size, 9 * size, radians(hfov_deg));
        return rescaled(draw_lens(base, CropOrder::base_first, options, stream).distortion,
                        0.5 * frame_on_plane(base).diagonal().norm());
      };
      const Distortion narrow = scaled(10, 40), wide = scaled(30, 140);
      CHECK(narrow.k1 == Approx(wide.k1));
      CHECK(narrow.k2 == Approx(wide.k2));
      CHECK(narrow.k3 == Approx(wide.k3));
      CHECK(narrow.p1 == Approx(wide.p1));
      CHECK(narrow.p2 == Approx(wide.p2));
    }
}

TEST_CASE("sequential draws have their share among the lenses of a prior") {
  const Pinhole base = pinhole_from_hfov(160, 90, radians(90));
  const LensOptions options{
      .scheme = LensScheme::shape_prior, .sequential_share = 0.2, .bounds = {}, .principal_point = {}};
  constexpr int count = 1000;
  int sequential = 0;
  for (int i = 0; i < count; ++i)
    sequential += draw_lens(base, CropOrder::base_first, options, substream(make_stream(2, "lens"), i))
                      .limits[0]
                      .has_value();
  CHECK(std::abs(sequential - 0.2 * count) < 3.3 * std::sqrt(count * 0.2 * 0.8));  // p = 0.001
}

TEST_CASE("where schemes are mixed each lens is the one of its scheme and each scheme has its share") {
  const Pinhole base = pinhole_from_hfov(160, 90, radians(70));
  const LensOptions mixed{.scheme = LensScheme::shape_prior,
                          .sequential_share = 0.2,
                          .real_lenses_share = 0.3,
                          .bounds = {},
                          .principal_point = {}};
  const std::pair<LensScheme, double> shares[] = {
      {LensScheme::sequential, 0.2}, {LensScheme::real_lenses, 0.3}, {LensScheme::shape_prior, 0.5}};
  constexpr int count = 300;
  int drawn[3] = {};
  for (int i = 0; i < count; ++i) {
    const Stream stream = substream(make_stream(5, "lens"), i);
    const DrawnLens lens = draw_lens(base, CropOrder::base_first, mixed, stream);
    int matching = 0;
    for (int s = 0; s < 3; ++s) {
      const LensOptions pure{
          .scheme = shares[s].first, .sequential_share = 0, .bounds = {}, .principal_point = {}};
      const bool is_of_scheme =
          draw_lens(base, CropOrder::base_first, pure, stream).distortion == lens.distortion;
      drawn[s] += is_of_scheme;
      matching += is_of_scheme;
    }
    CHECK(matching == 1);
  }
  for (int s = 0; s < 3; ++s) {
    INFO(to_string(shares[s].first));
    const double share = shares[s].second;
    CHECK(std::abs(drawn[s] - share * count) < 3.3 * std::sqrt(count * share * (1 - share)));  // p = 0.001
  }
}

TEST_CASE("lenses are of both kinds and do not repeat") {
  const Pinhole base = pinhole_from_hfov(480, 270, radians(90));
  int barrel = 0;
  double last_k1 = 0;
  for (int i = 0; i < 60; ++i) {
    const DrawnLens lens = draw_lens(base, CropOrder::base_first, {}, substream(make_stream(1, "lens"), i));
    barrel += lens.distortion.k1 < 0;
    CHECK(lens.distortion.k1 != last_k1);
    last_k1 = lens.distortion.k1;
  }
  CHECK(barrel > 10);
  CHECK(barrel < 50);
}

TEST_CASE("the undistorted lens leaves the camera as it is") {
  const Pinhole base = pinhole_from_hfov(480, 270, radians(90));
  const DrawnLens lens = undistorted_lens(base);
  CHECK(lens.distortion == Distortion{});
  CHECK(lens.crop.camera == base);
  CHECK(lens.crop.zoom == 1);
}
