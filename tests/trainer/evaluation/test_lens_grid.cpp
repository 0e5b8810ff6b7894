#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "numbers/angles.h"
#include "tests/trainer/street.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/evaluation/page/lens_grid.h"

using namespace cps;
using Eigen::Vector2d;

TEST_CASE("without distortion a grid's lines are straight and evenly spaced") {
  const CalibratedCamera camera{"", pinhole_from_hfov(480, 270, radians(70)), {}};
  const Eigen::AlignedBox2d frame = frame_on_plane(camera.pinhole), inner(.9 * frame.min(), .9 * frame.max());
  const std::vector<GridCurve> lines = lens_grid(camera, inner);
  // Squares of .9 · 480 / 12 = 36 pixels; .9 · 270 / 36 / 2 = 3.4 of them above and below the middle.
  REQUIRE(lines.size() == 13 + 7);
  for (int i = 0; i < 13; ++i)
    for (const Vector2d& point : lines[i]) CHECK(point.x() == Approx(24 + 36 * i));
  for (int i = 0; i < 7; ++i)
    for (const Vector2d& point : lines[13 + i]) CHECK(point.y() == Approx(135 + 36 * (i - 3)));
  CHECK(lines[0].front().y() == Approx(.05 * 270));
  CHECK(lines[0].back().y() == Approx(.95 * 270));
}

TEST_CASE("what a lens shows of a grid is straight without it") {
  double bend_px = 0;
  for (std::uint64_t lens = 1; lens < 6; ++lens) {
    const CalibratedCamera camera = draw_calibration({480, 270}, 80, lens);
    const Eigen::AlignedBox2d rectangle =
        certify_frame(camera.distortion, camera.pinhole, one_to_one).rectangle;
    Eigen::AlignedBox2d extent;
    const RayGrid rays = ray_grid(camera).value();
    for (const Vector2d& ideal : rays.ideal) extent.extend(ideal);
    for (const GridCurve& line : lens_grid(camera, extent)) {
      std::vector<Vector2d> ideal;
      for (const Vector2d& point : line)
        ideal.push_back(
            undistort(camera.distortion, rectangle, to_plane(camera.pinhole, point - Vector2d(.5, .5)))
                .value());
      const bool is_upright =
          std::abs(ideal.front().x() - ideal.back().x()) < std::abs(ideal.front().y() - ideal.back().y());
      for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector2d off = ideal[i] - ideal.front(), moved = line[i] - line.front();
        CHECK((is_upright ? off.x() : off.y()) == Approx(0).margin(1e-9));
        bend_px = std::max(bend_px, std::abs(is_upright ? moved.x() : moved.y()));
      }
    }
  }
  CHECK(bend_px > 2);
}

TEST_CASE("a grid ends before a lens folds and a camera without a middle shows none") {
  // k1 −1 folds at radius 1/√3: beyond it points come back towards the middle.
  const CalibratedCamera folding{"", pinhole_from_hfov(480, 270, radians(90)), {.k1 = -1}};
  REQUIRE(distort(folding.distortion, {.9, 0}).x() < distort(folding.distortion, {.5, 0}).x());
  const std::vector<GridCurve> lines = lens_grid(folding, frame_on_plane(folding.pinhole));
  REQUIRE(!lines.empty());
  int across = 0;
  for (const GridCurve& line : lines) {
    if (std::abs(line.back().x() - line.front().x()) < std::abs(line.back().y() - line.front().y())) continue;
    for (std::size_t i = 1; i < line.size(); ++i) CHECK(line[i].x() > line[i - 1].x());
    ++across;
  }
  CHECK(across > 0);

  CalibratedCamera beside = folding;
  beside.pinhole.cx = -100;
  CHECK(lens_grid(beside, frame_on_plane(folding.pinhole)).empty());
}
