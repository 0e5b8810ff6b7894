#include <catch2/catch.hpp>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "numbers/angles.h"

using namespace cps;

namespace {

struct Camera {
  Pinhole pinhole;
  Distortion lens;
};
// calib_cam_to_cam.txt of 2011-09-26 (Geiger et al. 2013): K_00 … K_03, D_00 … D_03.
const Camera kitti[]{{{1392, 512, 984.2439, 980.8141, 690.0, 233.1966},
                      {-0.3728755, 0.2037299, -0.07233722, 0.002219027, 0.001383707}},
                     {{1392, 512, 989.5267, 987.8386, 702.0, 245.5590},
                      {-0.3644661, 0.1790019, -0.05314062, 0.001148107, -0.0006298563}},
                     {{1392, 512, 959.7910, 956.9251, 696.0217, 224.1806},
                      {-0.3691481, 0.1968681, -0.06770705, 0.001353473, 0.0005677587}},
                     {{1392, 512, 903.7596, 901.9653, 695.7519, 224.2509},
                      {-0.3639558, 0.1788651, -0.05382460, 0.0006029694, -0.0003922424}}};

/// Distance in pixels from the frame's corner to the nearest image of any ideal point within radius 1.8.
double nearest_shown_px(const Camera& camera, const Eigen::Vector2d& corner_px) {
  const Eigen::Vector2d corner = to_plane(camera.pinhole, corner_px);
  const double heading = std::atan2(corner.y(), corner.x());
  double nearest = 1e9;
  for (double angle = heading - 0.1; angle < heading + 0.1; angle += 0.001)
    for (double r = 0.5; r < 1.8; r += 0.001)
      nearest = std::min(nearest,
                         (distort(camera.lens, {r * std::cos(angle), r * std::sin(angle)}) - corner).norm());
  return nearest * camera.pinhole.fx;
}

}  // namespace

TEST_CASE("KITTI's cameras 0 to 2 are one-to-one on their frames") {
  for (int i = 0; i < 3; ++i) {
    const auto& [pinhole, lens] = kitti[i];
    const FrameCertificate proof = certify_frame(lens, pinhole);
    INFO(proof.why);
    REQUIRE(proof.valid());
    // Every pixel has its ideal point in the rectangle, but not in a slightly smaller one.
    for (double x = -0.5; x <= pinhole.width; x += 48)
      for (double y = -0.5; y <= pinhole.height; y += 32)
        CHECK(undistort(lens, proof.rectangle, to_plane(pinhole, {x, y})).has_value());
    const Eigen::AlignedBox2d smaller(0.999 * proof.rectangle.min(), 0.999 * proof.rectangle.max());
    int missed = 0;
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-0.5, -0.5), Eigen::Vector2d(1391.5, -0.5),
                                          Eigen::Vector2d(-0.5, 511.5), Eigen::Vector2d(1391.5, 511.5)})
      missed += !undistort(lens, smaller, to_plane(pinhole, corner));
    CHECK(missed > 0);
  }
}

TEST_CASE("KITTI's camera 3 does not reach two corners of its frame") {
  const FrameCertificate proof = certify_frame(kitti[3].lens, kitti[3].pinhole, {1e-6, 10});
  CHECK_FALSE(proof.valid());
  CHECK_THAT(proof.why, Catch::Contains("folds") && Catch::Contains("99."));
  CHECK(proof.certificate.valid);  // one-to-one on the part that it reaches
  CHECK(nearest_shown_px(kitti[3], {-0.5, 511.5}) > 1.5);
  CHECK(nearest_shown_px(kitti[3], {1391.5, 511.5}) > 4);
  CHECK(nearest_shown_px(kitti[0], {1391.5, 511.5}) < 1);
}

TEST_CASE("a lens that folds just beyond its frame is certified on it") {
  // Drawn for a render of 115°. Growing the rectangle by 2 % jumps from inside the frame to beyond the fold.
  const Distortion lens{-0.042635001885946405, 0.008895786961052175, -0.0033479210753974815,
                        -0.004881219735804383, 0.006637300129192834};
  const Pinhole crop{.width = 480,
                     .height = 270,
                     .fx = 184.62992132804624,
                     .fy = 184.62992132804624,
                     .cx = 226.14267081453917,
                     .cy = 139.42517524221512};
  const FrameCertificate proof = certify_frame(lens, crop, one_to_one);
  REQUIRE(proof.valid());
  for (double x : {-0.5, 200.0, 479.5})
    for (double y : {-0.5, 100.0, 269.5})
      CHECK(undistort(lens, proof.rectangle, to_plane(crop, {x, y})).has_value());
}

TEST_CASE("impossible cameras are refused, naming the field") {
  const Pinhole good = pinhole_from_hfov(640, 480, radians(90));
  Pinhole bad = good;
  bad.fx = 0;
  CHECK_THAT(certify_frame({}, bad).why, Catch::Contains("fx"));
  bad = good;
  bad.cx = 900;
  CHECK_THAT(certify_frame({}, bad).why, Catch::Contains("principal point"));
  bad = good;
  bad.width = 0;
  CHECK_THAT(certify_frame({}, bad).why, Catch::Contains("width"));
  CHECK_FALSE(certify_frame({.k1 = -0.5}, good).valid());
  CHECK_FALSE(certify_frame({.k1 = std::nan("")}, good).valid());
  CHECK(certify_frame({}, good).valid());
  CHECK(certify_frame({}, good).rectangle.isApprox(frame_on_plane(good), 1e-8));
}
