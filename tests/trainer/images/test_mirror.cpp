#include <catch2/catch.hpp>

#include "tests/trainer/street.h"
#include "trainer/images/mirror.h"

using namespace cps;

TEST_CASE("a mirrored calibration puts the mirrored point on the mirrored pixel") {
  for (std::uint64_t lens = 1; lens <= 20; ++lens) {
    const Calibration c = draw_calibration({480, 270}, 40 + 3.0 * static_cast<double>(lens), lens),
                      m = mirrored(c);
    const Eigen::AlignedBox2d frame = frame_on_plane(c.camera);
    for (double u : {0.0, .3, .8, 1.0})
      for (double v : {0.0, .4, 1.0}) {
        const Eigen::Vector2d point = frame.min() + frame.sizes().cwiseProduct(Eigen::Vector2d(u, v));
        const Eigen::Vector2d pixel = to_pixel(c.camera, distort(c.distortion, point));
        const Eigen::Vector2d other = to_pixel(m.camera, distort(m.distortion, {-point.x(), point.y()}));
        CHECK(other.x() == Approx(479 - pixel.x()).margin(1e-9));
        CHECK(other.y() == Approx(pixel.y()).margin(1e-9));
      }
    const Outputs twice = to_outputs(mirrored(m), TargetSpace::raw), once = to_outputs(c, TargetSpace::raw);
    for (int i = 0; i < output_count; ++i) CHECK(twice[i] == Approx(once[i]).epsilon(1e-14));
  }
}
