#include <catch2/catch.hpp>

#include "distortion/certificate/certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/inverse/inverse_map.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

namespace {

struct RoundTrip {
  long certified = 0, failed = 0;
  double worst_px = 0;        ///< |D(undistort(d)) − d|
  double worst_ideal_px = 0;  ///< |undistort(D(x)) − x|
};

/// Random certified lenses, each with some points of its rectangle, corners included.
RoundTrip round_trips(long lenses, int points) {
  const Stream stream = make_stream(6, "inverse");
  RoundTrip result;
  for (long i = 0; result.certified < lenses; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = i % 8 ? random_lens(stream, i, camera) : wild_lens(stream, i, camera);
    const auto box = frame_on_plane(camera);
    if (!is_certified(lens, box)) continue;
    ++result.certified;
    const Stream where = substream(stream, ~i);
    for (int k = 0; k < points; ++k) {
      const Eigen::Vector2d x =
          k == 0 ? box.corner(Eigen::AlignedBox2d::CornerType(i % 4)) : random_point(where, k, box);
      const Eigen::Vector2d distorted = distort(lens, x);
      const auto ideal = undistort(lens, box, distorted);
      if (!ideal) {
        ++result.failed;
        continue;
      }
      result.worst_px = std::max(result.worst_px, camera.fx * (distort(lens, *ideal) - distorted).norm());
      result.worst_ideal_px = std::max(result.worst_ideal_px, camera.fx * (*ideal - x).norm());
    }
  }
  return result;
}

}  // namespace

TEST_CASE("every point of a certified lens comes back") {
  const RoundTrip result = round_trips(20'000, 5);
  INFO("worst " << result.worst_px << " px, ideal " << result.worst_ideal_px << " px");
  CHECK(result.failed == 0);
  CHECK(result.worst_px < 1e-9);
  CHECK(result.worst_ideal_px < 1e-8);
}

TEST_CASE("a million certified lenses", "[slow]") {
  const RoundTrip result = round_trips(1'000'000, 16);
  WARN("worst round trip " << result.worst_px << " px, in ideal pixels " << result.worst_ideal_px << " px");
  CHECK(result.failed == 0);
  CHECK(result.worst_px < 1e-6);
}

TEST_CASE("targets outside the image of the box are found to be outside") {
  const Stream stream = make_stream(7, "outside");
  int tried = 0;
  for (int i = 0; i < 3000; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = random_lens(stream, i, camera);
    const auto box = frame_on_plane(camera);
    // A lens certified on a larger box is one-to-one there, so the image of a point in the larger box but not
    // in the smaller one lies outside D(box).
    const Eigen::AlignedBox2d larger(1.2 * box.min(), 1.2 * box.max());
    if (!is_certified(lens, larger)) continue;
    const Eigen::Vector2d x = random_point(substream(stream, i), 0, larger);
    const bool is_inside = box.contains(x);
    if (!is_inside && box.exteriorDistance(x) < 1e-6) continue;
    ++tried;
    CHECK(undistort(lens, box, distort(lens, x)).has_value() == is_inside);
  }
  CHECK(tried > 1000);
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));
  CHECK_FALSE(undistort({.k1 = -0.1}, box, {1e6, 3}));
  CHECK_FALSE(undistort({.k1 = -0.1}, box, {std::nan(""), 0}));
}

TEST_CASE("the tile map agrees with the inverse point by point") {
  const Stream stream = make_stream(8, "tile");
  auto tile = std::make_unique<InverseMapTile>();
  for (int i = 0; i < 60; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = random_lens(stream, i, camera);
    const auto frame = frame_on_plane(camera);
    const Eigen::AlignedBox2d box(1.02 * frame.min(), 1.02 * frame.max());
    if (!is_certified(lens, box)) continue;
    const int width = 1 + int(random_below(stream, 5000 + i, 64)),
              height = 1 + int(random_below(stream, 6000 + i, 64));
    const int x0 = int(random_below(stream, 7000 + i, camera.width - width + 1)),
              y0 = i % 2 ? 0 : camera.height - height;
    invert_tile(lens, box, camera, {x0, y0, width, height}, *tile);
    CHECK(tile->worst_residual_px < 1e-9);
    int outside = 0;
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const auto ideal = undistort(lens, box, to_plane(camera, {x0 + column, y0 + row}));
        const Eigen::Vector2d found(tile->x[tile->index(column, row)], tile->y[tile->index(column, row)]);
        outside += !ideal;
        if (ideal)
          REQUIRE((found - *ideal).norm() * camera.fx < 1e-7);
        else
          REQUIRE(std::isnan(found.x()));
      }
    CHECK(tile->outside == outside);
    CHECK(tile->fallbacks == outside);  // inside D(box) the vectorised steps were enough
  }
}
