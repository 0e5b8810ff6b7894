#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/certificate.h"
#include "distortion/displacement.h"
#include "distortion/warp.h"
#include "sampler/lens_draw.h"

using namespace cps;

namespace {

struct Setting {
  Pinhole base;
  Eigen::AlignedBox2d padded_master;
};

Setting setting(int width, int height, double hfov_deg) {
  const Pinhole base = pinhole_from_hfov(width, height, radians(hfov_deg));
  return {base, frame_on_plane(master_camera(base, WarpOptions{}, LensBounds{}.min_eigenvalue))};
}

}  // namespace

TEST_CASE("every drawn lens is certified on the padded master, within its limits and its crop's caps") {
  const LensBounds bounds;
  const PrincipalPointBounds principal_point;
  for (double hfov_deg : {30.0, 90.0, 150.0})
    for (int i = 0; i < 40; ++i) {
      const Setting s = setting(i % 2 ? 480 : 348, i % 2 ? 270 : 128, hfov_deg);
      const DrawnLens lens =
          draw_lens(s.base, s.padded_master, bounds, principal_point, substream(make_stream(0, "lens"), i));
      CHECK(certify(lens.distortion, s.padded_master).valid);
      CHECK(largest_displacement(lens.distortion, s.padded_master) <= bounds.max_displacement * (1 + 1e-9));
      CHECK(lens.crop.zoom >= 1);
      CHECK(lens.crop.zoom <= principal_point.max_zoom);
      const double values[7] = {lens.distortion.k1, lens.distortion.k2, lens.distortion.k3,
                                lens.distortion.p1, lens.distortion.p2, lens.crop.camera.cx,
                                lens.crop.camera.cy};
      for (int k = 0; k < 7; ++k) {
        REQUIRE(lens.limits[k].has_value());
        CHECK(values[k] >= lens.limits[k]->low);
        CHECK(values[k] <= lens.limits[k]->high);
      }
      CHECK(std::abs(lens.crop.camera.cx - s.base.cx) <= 0.03 * s.base.width);
      CHECK(std::abs(lens.crop.camera.cy - s.base.cy) <= 0.08 * s.base.height);
    }
}

TEST_CASE("lenses are of both kinds and do not repeat") {
  const Setting s = setting(480, 270, 90);
  int barrel = 0;
  double last_k1 = 0;
  for (int i = 0; i < 60; ++i) {
    const DrawnLens lens = draw_lens(s.base, s.padded_master, {}, {}, substream(make_stream(1, "lens"), i));
    barrel += lens.distortion.k1 < 0;
    CHECK(lens.distortion.k1 != last_k1);
    last_k1 = lens.distortion.k1;
  }
  CHECK(barrel > 10);
  CHECK(barrel < 50);
}

TEST_CASE("the undistorted lens leaves the camera as it is") {
  const Setting s = setting(480, 270, 90);
  const DrawnLens lens = undistorted_lens(s.base);
  CHECK(lens.distortion == Distortion{});
  CHECK(lens.crop.camera == s.base);
  CHECK(lens.crop.zoom == 1);
}
