#include <torch/types.h>

#include <catch2/catch.hpp>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "distortion/label_algebra.h"
#include "tests/trainer/street.h"
#include "trainer/network/tensor_batch.h"

using namespace cps;

TEST_CASE("a mirrored training image shows the mirrored world through the mirrored label") {
  for (std::uint64_t lens = 1; lens <= 20; ++lens) {
    const CalibratedCamera camera = draw_calibration({48, 27}, 40 + 3.0 * static_cast<double>(lens), lens),
                           mirrored = mirrored_left_right(camera);
    const FrameCertificate frame = certify_frame(camera.distortion, camera.pinhole);
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{47, 26}, std::pair{11, 20}, std::pair{30, 4}}) {
      // A bright pixel, and the point of the world that it shows.
      const auto point =
          undistort(camera.distortion, frame.rectangle, to_plane(camera.pinhole, Eigen::Vector2d(x, y)));
      REQUIRE(point);
      std::vector<std::uint8_t> pixels(48 * 27, 0);
      pixels[y * 48 + x] = 255;
      // The network's image, flipped, has one bright pixel: where the mirrored camera sees the mirrored
      // point.
      const BatchImage image{{{48, 27}, pixels.data()}, {48, 27}, true};
      const torch::Tensor shown = image_tensor(std::span(&image, 1), {.mean = 0, .deviation = 1})[0][0];
      const std::int64_t brightest = shown.argmax().item<std::int64_t>();
      CHECK(shown.sum().item<double>() == 255);
      const Eigen::Vector2d expected =
          to_pixel(mirrored.pinhole, distort(mirrored.distortion, {-point->x(), point->y()}));
      CHECK(expected.x() == Approx(static_cast<double>(brightest % 48)).margin(1e-6));
      CHECK(expected.y() == Approx(static_cast<double>(brightest / 48)).margin(1e-6));
    }
  }
}
