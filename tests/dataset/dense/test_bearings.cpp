#include <catch2/catch.hpp>
#include <numbers>
#include <opencv2/calib3d.hpp>

#include "dataset/dense/bearings.h"
#include "distortion/certificate/frame_certificate.h"
#include "numbers/angles.h"
#include "tests/distortion/barrel.h"

using namespace cps;

namespace {

/// Half of the last bit of a float between ½ and 1, such as a unit vector's largest component.
constexpr double float_rounding = 0x1p-25;

/// The part of what a camera sees through a strong barrel that a dataset would show: without its rim, where
/// the lens folds.
CalibratedCamera cropped_barrel(const Pinhole& base) {
  Pinhole pinhole = base;
  pinhole.fx *= 1.8;
  pinhole.fy *= 1.8;
  return {.name = "", .pinhole = pinhole, .distortion = barrel(base)};
}

/// With strong tangential terms, before a sensor whose principal point is off its middle and whose pixels are
/// not square.
CalibratedCamera strong_camera() {
  CalibratedCamera camera = cropped_barrel(pinhole_from_hfov(160, 90, radians(100)));
  auto& [name, pinhole, lens] = camera;
  pinhole.fy *= 1.05;
  pinhole.cx += 6.625;
  pinhole.cy -= 4.25;
  lens.p1 *= 4;
  lens.p2 *= 4;
  return camera;
}

/// Downwards as a camera sees it that is pitched up and then rolled clockwise.
Eigen::Vector3d gravity_of(double pitch_deg, double roll_deg) {
  const double pitch = radians(pitch_deg), roll = radians(roll_deg);
  return {std::sin(roll) * std::cos(pitch), std::cos(roll) * std::cos(pitch), -std::sin(pitch)};
}

/// OpenCV's pixel of a point in the camera frame.
Eigen::Vector2d project(const CalibratedCamera& camera, const Eigen::Vector3d& point) {
  const auto& [name, pinhole, lens] = camera;
  const std::vector<cv::Point3d> points{{point.x(), point.y(), point.z()}};
  const cv::Matx33d K(pinhole.fx, 0, pinhole.cx, 0, pinhole.fy, pinhole.cy, 0, 0, 1);
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), K,
                    std::vector<double>{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}, pixels);
  return {pixels[0].x, pixels[0].y};
}

/// A label's value at a pixel.
template <int channels>
Eigen::Matrix<double, channels, 1> at(const OIIO::ImageBuf& image, int x, int y) {
  REQUIRE(image.nchannels() == channels);
  const auto* values = static_cast<const float*>(image.localpixels());
  return Eigen::Matrix<float, channels, 1>::Map(values + channels * (y * image.spec().width + x))
      .template cast<double>();
}

/// Calls for each pixel.
template <typename Function>
void for_pixels(const Pinhole& pinhole, Function function) {
  for (int y = 0; y < pinhole.height; ++y)
    for (int x = 0; x < pinhole.width; ++x) function(x, y);
}

const Eigen::Vector3d level(0, 1, 0);

}  // namespace

TEST_CASE("OpenCV projects every ray to its pixel's centre") {
  const CalibratedCamera camera = strong_camera();
  const OIIO::ImageBuf rays = bearing_label(camera, level, DenseLabel::rays);
  double worst_px = 0, worst_length = 0, largest_px_per_plane = 0;
  for_pixels(camera.pinhole, [&](int x, int y) {
    const auto ray = at<3>(rays, x, y);
    worst_px = std::max(worst_px, (project(camera, ray) - Eigen::Vector2d(x, y)).norm());
    worst_length = std::max(worst_length, std::abs(ray.norm() - 1));
    const double r = ray.head<2>().norm() / ray.z();
    largest_px_per_plane = std::max(largest_px_per_plane, camera.pinhole.fy * (1 + r) * std::hypot(1, r));
  });
  // Each component is off by a rounding. On the plane z = 1 that makes at most √2 (1 + r)/z of it with
  // 1/z = √(1 + r²), and the lens enlarges by at most the certificate's largest eigenvalue.
  const FrameCertificate proof = certify_frame(camera.distortion, camera.pinhole, one_to_one);
  REQUIRE(proof.valid());
  const double tolerance_px = std::numbers::sqrt2 * float_rounding * largest_px_per_plane *
                              std::max(1.0, proof.certificate.max_eigenvalue);
  CHECK(tolerance_px < 2e-5);
  CHECK(worst_px < tolerance_px);
  CHECK(worst_length < 2 * float_rounding);
}

TEST_CASE("up is where OpenCV's pixel of a rising point goes") {
  const CalibratedCamera camera = strong_camera();
  const Eigen::Vector3d gravity = gravity_of(-7, 11);
  const OIIO::ImageBuf rays = bearing_label(camera, gravity, DenseLabel::rays);
  const OIIO::ImageBuf up = bearing_label(camera, gravity, DenseLabel::up);
  double worst = 0, most_sideways = 0;
  for_pixels(camera.pinhole, [&](int x, int y) {
    const Eigen::Vector3d point = at<3>(rays, x, y), step = -1e-4 * gravity;
    const Eigen::Vector2d difference = project(camera, point + step) - project(camera, point - step);
    worst = std::max(worst, (at<2>(up, x, y) - difference.normalized()).norm());
    most_sideways = std::max(most_sideways, std::abs(at<2>(up, x, y).x()));
  });
  // The central difference is off by about 1e-4² times the third derivative, up by two roundings, and the
  // ray's own turn it by a few more.
  CHECK(worst < 4 * float_rounding);
  CHECK(most_sideways > 0.3);  // the camera's roll and the lens' bend
}

TEST_CASE("latitude is what the ray's angle to the vertical leaves of 90 degrees") {
  const CalibratedCamera camera = strong_camera();
  const Eigen::Vector3d gravity = gravity_of(75, -20);  // the zenith is in the picture
  const OIIO::ImageBuf rays = bearing_label(camera, gravity, DenseLabel::rays);
  const OIIO::ImageBuf latitude = bearing_label(camera, gravity, DenseLabel::latitude);
  double worst_deg = 0, highest_deg = -90, lowest_deg = 90;
  for_pixels(camera.pinhole, [&](int x, int y) {
    const Eigen::Vector3d ray = at<3>(rays, x, y);
    const double deg = at<1>(latitude, x, y)[0];
    // Kahan's angle between two vectors of one length, exact everywhere.
    const double from_zenith =
        2 * std::atan2((ray.normalized() + gravity).norm(), (ray.normalized() - gravity).norm());
    worst_deg = std::max(worst_deg, std::abs(deg - (90 - degrees(from_zenith))));
    highest_deg = std::max(highest_deg, deg);
    lowest_deg = std::min(lowest_deg, deg);
  });
  // The ray's roundings, up to √3 of them, and that of a float between 64 and 128.
  CHECK(worst_deg < degrees(std::numbers::sqrt3 * float_rounding) + 0x1p-18);
  CHECK(highest_deg > 89);
  CHECK(lowest_deg < 60);
}

TEST_CASE("bearings of a camera without distortion have closed forms") {
  const Pinhole pinhole = pinhole_from_hfov(64, 48, radians(90));
  const CalibratedCamera camera{.name = "", .pinhole = pinhole, .distortion = {}};
  const double roll = radians(25);
  const OIIO::ImageBuf rays = bearing_label(camera, level, DenseLabel::rays);
  const OIIO::ImageBuf upright = bearing_label(camera, level, DenseLabel::up);
  const OIIO::ImageBuf rolled = bearing_label(camera, gravity_of(0, 25), DenseLabel::up);
  const OIIO::ImageBuf latitude = bearing_label(camera, level, DenseLabel::latitude);
  for_pixels(pinhole, [&](int x, int y) {
    const double u = (x - 31.5) / 32, v = (y - 23.5) / 32;  // 90° are 64 pixels
    const double length = std::sqrt(1 + u * u + v * v);
    CHECK((at<3>(rays, x, y) - Eigen::Vector3d(u, v, 1) / length).norm() < 2 * float_rounding);
    // In a level camera verticals are vertical and parallel in the picture; in a rolled one parallel.
    CHECK(at<2>(upright, x, y) == Eigen::Vector2d(0, -1));
    CHECK((at<2>(rolled, x, y) + Eigen::Vector2d(std::sin(roll), std::cos(roll))).norm() <
          2 * float_rounding);
    // A float below 45 is off by at most 2^-19.
    CHECK(std::abs(at<1>(latitude, x, y)[0] - degrees(std::asin(-v / length))) < 0x1p-18);
  });
}

TEST_CASE("seen along the vertical, up leads away from the nadir and towards the zenith") {
  // Odd sizes: a pixel's centre is the principal point, where the ray is vertical and up is nowhere.
  CalibratedCamera camera = cropped_barrel(pinhole_from_hfov(65, 49, radians(90)));
  const auto [is_straight, sign] =
      GENERATE(table<bool, int>({{true, 1}, {true, -1}, {false, 1}, {false, -1}}));
  if (is_straight) camera.distortion = {};
  const Eigen::Vector3d gravity(0, 0, sign);  // 1: the camera looks down
  const OIIO::ImageBuf up = bearing_label(camera, gravity, DenseLabel::up);
  const OIIO::ImageBuf latitude = bearing_label(camera, gravity, DenseLabel::latitude);
  CHECK(at<2>(up, 32, 24) == Eigen::Vector2d(0, 0));
  CHECK(at<1>(latitude, 32, 24)[0] == -90 * sign);
  double least_outwards = 1;
  for_pixels(camera.pinhole, [&](int x, int y) {
    if (x == 32 && y == 24) return;
    const Eigen::Vector2d outwards = sign * Eigen::Vector2d(x - 32, y - 24).normalized();
    CHECK(std::abs(at<2>(up, x, y).norm() - 1) < 2 * float_rounding);
    least_outwards = std::min(least_outwards, at<2>(up, x, y).dot(outwards));
  });
  // Straight outwards but for the tangential terms, which turn it a little.
  CHECK(least_outwards > (is_straight ? 1 - 4 * float_rounding : 0.99));
}

TEST_CASE("bearings are refused where no ray is behind a pixel, or where the scene decides") {
  CalibratedCamera camera = strong_camera();
  CHECK_THROWS_WITH(bearing_label(camera, level, DenseLabel::depth),
                    Catch::StartsWith("depth: does not follow from the camera"));
  camera.distortion.k1 = -1;
  CHECK_THROWS_WITH(bearing_label(camera, level, DenseLabel::rays),
                    Catch::StartsWith("lens: not one-to-one on the picture") && !Catch::Contains("\n"));
}
