#include <catch2/catch.hpp>

#include "distortion/certificate/displacement.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

TEST_CASE("the displacement is an upper bound, and a tight one") {
  const Stream stream = make_stream(9, "displacement");
  for (int i = 0; i < 500; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = wild_lens(stream, i, camera);
    Eigen::AlignedBox2d box = frame_on_plane(camera);
    if (i % 2) box.translate(0.5 * random_point(substream(stream, i), 0, box));
    const double half_diagonal = 0.5 * box.diagonal().norm();
    double on_grid = 0;
    constexpr int steps = 150;
    for (int y = 0; y <= steps; ++y)
      for (int x = 0; x <= steps; ++x) {
        const Eigen::Vector2d at = box.min() + box.sizes().cwiseProduct(Eigen::Vector2d(x, y) / steps);
        on_grid = std::max(on_grid, (distort(lens, at) - at).norm() / half_diagonal);
      }
    const double bound = largest_displacement(lens, box);
    CHECK(bound >= on_grid * (1 - 1e-12));
    CHECK(bound < on_grid * 1.01 + 1e-5);
  }
}

TEST_CASE("displacement of one coefficient in closed form") {
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-0.8, -0.6), Eigen::Vector2d(0.8, 0.6));
  CHECK(largest_displacement({.k1 = -0.2}, box) == Approx(0.2).margin(2e-6));
  CHECK(largest_displacement({}, box) < 1e-11);
}
