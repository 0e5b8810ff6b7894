#include <catch2/catch.hpp>

#include "distortion/pinhole.h"
#include "numbers/angles.h"

using namespace cps;

TEST_CASE("a pinhole has the field of view it was made with") {
  for (double deg : {30.0, 90.0, 150.0}) {
    const Pinhole camera = pinhole_from_hfov(1392, 512, radians(deg));
    CHECK(degrees(hfov_rad(camera)) == Approx(deg).epsilon(1e-14));
    const auto frame = frame_on_plane(camera);
    CHECK(frame.max().x() == Approx(std::tan(radians(deg / 2))));
    CHECK(frame.center().norm() < 1e-15);
  }
}

TEST_CASE("oversampling and padding keep every ray where it was") {
  const Pinhole camera{640, 480, 500, 510, 310.25, 250.5};
  const Pinhole fine = oversampled(camera, 3, 7);
  CHECK(fine.width == 3 * 640 + 14);
  CHECK(fine.height == 3 * 480 + 14);
  // The centre of pixel (i, j) is the centre of its middle subpixel.
  const Eigen::Vector2d pixel(17, 401);
  const Eigen::Vector2d middle = to_pixel(fine, to_plane(camera, pixel));
  CHECK(middle.x() == Approx(3 * 17 + 1 + 7));
  CHECK(middle.y() == Approx(3 * 401 + 1 + 7));
  CHECK((frame_on_plane(oversampled(camera, 3)).min() - frame_on_plane(camera).min()).norm() < 1e-15);
  CHECK((frame_on_plane(oversampled(camera, 3)).max() - frame_on_plane(camera).max()).norm() < 1e-15);
}
