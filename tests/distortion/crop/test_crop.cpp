#include <boost/math/tools/toms748_solve.hpp>
#include <catch2/catch.hpp>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/crop/crop.h"
#include "distortion/crop/true_fov.h"
#include "distortion/inverse/inverse.h"
#include "numbers/angles.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

namespace {

Eigen::Vector2d random_principal_point(Stream stream, std::uint64_t index, const Pinhole& camera) {
  return {camera.cx + camera.width * random_uniform(stream, 2 * index, -0.03, 0.03),
          camera.cy + camera.height * random_uniform(stream, 2 * index + 1, -0.08, 0.08)};
}

/// The zoom by an independent method: a bracketing root finder for the zoom at which the inverses of points
/// on the final frame's rim just stay inside the master.
double zoom_by_root_finding(const Distortion& lens, const Pinhole& base,
                            const Eigen::Vector2d& principal_point) {
  const auto master = frame_on_plane(base);
  // The master, slightly enlarged, so that the inverse exists around its rim.
  const Eigen::AlignedBox2d room(1.05 * master.min(), 1.05 * master.max());
  const auto excess = [&](double zoom) {  // > 0: the frame sees beyond the master
    const Pinhole camera{base.width,     base.height,         zoom * base.fx,
                         zoom * base.fy, principal_point.x(), principal_point.y()};
    double worst = -1;
    for (int i = 0; i <= 4000; ++i)
      for (int side = 0; side < 4; ++side) {
        const double t = i / 4000.0, x = -0.5 + t * base.width, y = -0.5 + t * base.height;
        const Eigen::Vector2d pixel = side == 0   ? Eigen::Vector2d(x, -0.5)
                                      : side == 1 ? Eigen::Vector2d(x, base.height - 0.5)
                                      : side == 2 ? Eigen::Vector2d(-0.5, y)
                                                  : Eigen::Vector2d(base.width - 0.5, y);
        const auto ideal = undistort(lens, room, to_plane(camera, pixel));
        if (!ideal) return 0.05;
        worst = std::max({worst, std::abs(ideal->x()) / master.max().x() - 1,
                          std::abs(ideal->y()) / master.max().y() - 1});
      }
    return worst;
  };
  if (excess(1) <= 0) return 1;
  std::uintmax_t iterations = 60;
  const auto close = [](double a, double b) { return std::abs(b - a) < 1e-10; };
  const auto [low, high] = boost::math::tools::toms748_solve(excess, 1.0, 4.0, close, iterations);
  return high;
}

}  // namespace

TEST_CASE("the crop leaves no border and wastes no image") {
  const Stream stream = make_stream(10, "crop");
  int cropped = 0, touching = 0;
  for (int i = 0; i < 400; ++i) {
    const Pinhole base = random_camera(stream, i);
    const Distortion lens = random_lens(stream, i, base);
    const auto master = frame_on_plane(base);
    if (!is_certified(lens, master)) continue;
    const Crop crop = border_free_crop(lens, base, random_principal_point(substream(stream, i), 0, base),
                                       {.max_magnification = 10});
    INFO(crop.why);
    REQUIRE(crop.valid);
    CHECK(crop.worst_roundtrip_px < 1e-8);
    CHECK(crop.camera.fx == base.fx * crop.zoom);
    ++cropped;
    if (crop.zoom == 1) continue;
    // A slightly larger frame would see past the master: some point of the master's rim lies inside it.
    Pinhole wider = crop.camera;
    wider.fx *= 1 - 2e-4;
    wider.fy *= 1 - 2e-4;
    const auto wider_frame = frame_on_plane(wider);
    bool touches = false;
    constexpr int steps = 20'000;
    for (int k = 0; k <= steps && !touches; ++k)
      for (int side = 0; side < 4; ++side) {
        const double t = double(k) / steps;
        const int axis = side % 2;
        Eigen::Vector2d b;
        b[axis] = master.min()[axis] + t * master.sizes()[axis];
        b[1 - axis] = side < 2 ? master.min()[1 - axis] : master.max()[1 - axis];
        if (wider_frame.contains(distort(lens, b))) touches = true;
      }
    touching += touches;
    CHECK(touches);
  }
  CHECK(cropped > 200);
  CHECK(touching > 100);
}

TEST_CASE("the crop agrees with a bracketing root finder on the inverse") {
  const Stream stream = make_stream(11, "crop root");
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Pinhole base = random_camera(stream, i);
    const Distortion lens = random_lens(stream, i, base);
    const auto master = frame_on_plane(base);
    if (!is_certified(lens, {1.05 * master.min(), 1.05 * master.max()})) continue;
    const Eigen::Vector2d principal_point = random_principal_point(substream(stream, i), 0, base);
    const double zoom = border_free_zoom(lens, base, principal_point);
    const double found = zoom_by_root_finding(lens, base, principal_point);
    ++compared;
    CHECK(zoom >= found - 1e-8);  // the root finder looks at finitely many points, so it can only miss
    CHECK(zoom == Approx(found).epsilon(1e-6));
  }
  CHECK(compared > 20);
}

TEST_CASE("no distortion, no crop; a shifted principal point costs what geometry says") {
  const Pinhole base = pinhole_from_hfov(1000, 500, radians(60));
  const Crop none = border_free_crop({}, base, {base.cx, base.cy});
  CHECK(none.valid);
  CHECK(none.zoom == Approx(1).epsilon(1e-8));
  // 40 px right of the centre: 540 px must fit where 500 did.
  const Crop shifted = border_free_crop({}, base, {base.cx + 40, base.cy});
  CHECK(shifted.zoom == Approx(540.0 / 500).epsilon(1e-8));
  CHECK(hfov_rad(shifted.camera) == Approx(2 * std::atan(std::tan(radians(30)) * 500 / 540)));
}

TEST_CASE("refused crops say why") {
  const Pinhole base = pinhole_from_hfov(640, 480, radians(90));
  const Eigen::Vector2d centre(base.cx, base.cy);
  CHECK_THAT(border_free_crop({.k1 = -0.4}, base, centre).why, Catch::Contains("folds"));
  CHECK_THAT(border_free_crop({}, base, {700, 100}).why, Catch::Contains("principal point"));
  CHECK_THAT(border_free_crop({.k1 = -0.15}, base, centre, {.max_zoom = 1.1}).why, Catch::Contains("cap"));
  CHECK_THAT(border_free_crop({.k1 = -0.15}, base, centre, {.max_magnification = 1.05}).why,
             Catch::Contains("magnification"));
  CHECK_THAT(border_free_crop({}, Pinhole{640, 480, 0, 0, 320, 240}, centre).why, Catch::Contains("focal"));
  CHECK_FALSE(border_free_crop({.k1 = std::nan("")}, base, centre).valid);
  CHECK_THAT(border_free_crop({}, base, centre, {.max_zoom = 0.5}).why, Catch::Contains("max_zoom"));
}

TEST_CASE("label-first: the base makes the crop end at the label's field of view") {
  const Stream stream = make_stream(12, "label first");
  int tried = 0;
  for (int i = 0; i < 200; ++i) {
    const Pinhole wanted = random_camera(stream, i);
    const double half_diagonal = 0.5 * frame_on_plane(wanted).diagonal().norm();
    const Distortion scaled = rescaled(random_lens(stream, i, wanted), half_diagonal);
    const Eigen::Vector2d principal_point = random_principal_point(substream(stream, i), 0, wanted);
    const LabelFirst first =
        base_for_final_hfov(scaled, wanted.width, wanted.height, hfov_rad(wanted), principal_point);
    const Crop crop = border_free_crop(first.lens, first.base, principal_point, {.max_magnification = 10});
    if (!crop.valid) continue;
    ++tried;
    CHECK(hfov_rad(crop.camera) == Approx(hfov_rad(wanted)).epsilon(1e-9));
  }
  CHECK(tried > 100);
}

TEST_CASE("true angles") {
  const Pinhole camera = pinhole_from_hfov(1392, 512, radians(80));
  const auto box = frame_on_plane(camera);
  const Eigen::AlignedBox2d room(2 * box.min(), 2 * box.max());
  const auto ideal = true_fov({}, camera, room);
  REQUIRE(ideal);
  CHECK(degrees(ideal->horizontal_rad) == Approx(80));
  CHECK(ideal->vertical_rad == Approx(2 * std::atan(256 / camera.fx)));
  CHECK(ideal->diagonal_rad == Approx(2 * std::atan(std::hypot(696, 256) / camera.fx)));
  CHECK_FALSE(true_fov({.k1 = -0.1}, camera, box));  // a barrel lens sees beyond the pinhole's frame

  // Off-centre: the diagonals differ, and the wider one counts.
  const Pinhole off_centre{1000, 600, 500, 500, 300, 200};
  const auto between = [&](double xa, double ya, double xb, double yb) {
    const Eigen::Vector3d a(xa - 300, ya - 200, 500), b(xb - 300, yb - 200, 500);
    return std::acos(a.normalized().dot(b.normalized()));
  };
  const double falling = between(-0.5, -0.5, 999.5, 599.5), rising = between(-0.5, 599.5, 999.5, -0.5);
  REQUIRE(std::abs(falling - rising) > 1e-3);
  const auto off = true_fov({}, off_centre, {Eigen::Vector2d(-3, -3), Eigen::Vector2d(3, 3)});
  REQUIRE(off);
  CHECK(off->diagonal_rad == Approx(std::max(falling, rising)));

  // KITTI's camera 0 (2011-09-26): a label of 70.5°, though it sees 83°.
  const Pinhole kitti{1392, 512, 984.2439, 980.8141, 690.0, 233.1966};
  const Distortion lens{-0.3728755, 0.2037299, -0.07233722, 0.002219027, 0.001383707};
  const auto seen = true_fov(lens, kitti, certify_frame(lens, kitti).rectangle);
  REQUIRE(seen);
  CHECK(degrees(hfov_rad(kitti)) == Approx(70.5).margin(0.1));
  CHECK(degrees(seen->horizontal_rad) == Approx(83.1).margin(0.05));
}
