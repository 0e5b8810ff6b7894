#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numbers>
#include <opencv2/calib3d.hpp>

#include "dataset/dense/bearings.h"
#include "numbers/angles.h"

using namespace cps;

namespace {

const KannalaBrandt bent{-0.03, 0.004, -0.0006, 0.00003};

/// Its principal point is off the middle, and its corners see beyond 90° off the axis.
const ModelCamera fisheye_camera{"", {120, 90, 42, 43.5, 61.25, 42}, bent};

/// OpenCV's pixel of a point ahead of the camera.
Eigen::Vector2d opencv_pixel(const ModelCamera& camera, const Eigen::Vector3d& point) {
  const Pinhole& p = camera.pinhole;
  const std::vector<cv::Point3d> points{{point.x(), point.y(), point.z()}};
  std::vector<cv::Point2d> pixels;
  cv::fisheye::projectPoints(points, pixels, cv::Vec3d(), cv::Vec3d(),
                             cv::Matx33d(p.fx, 0, p.cx, 0, p.fy, p.cy, 0, 0, 1),
                             cv::Vec4d(bent.k1, bent.k2, bent.k3, bent.k4));
  return {pixels[0].x, pixels[0].y};
}

Eigen::Vector3d ray_at(const OIIO::ImageBuf& rays, int x, int y) {
  return Eigen::Vector3f(rays.getchannel(x, y, 0, 0), rays.getchannel(x, y, 0, 1),
                         rays.getchannel(x, y, 0, 2))
      .cast<double>();
}

/// Downwards for a camera that is pitched up by 12° and then rolled by 7°.
const Eigen::Vector3d tilted = Eigen::AngleAxisd(radians(7), Eigen::Vector3d::UnitZ()) *
                               Eigen::Vector3d(0, std::cos(radians(12)), -std::sin(radians(12)));

}  // namespace

TEST_CASE("OpenCV's fisheye projects every ray ahead to its pixel's centre") {
  const OIIO::ImageBuf rays = bearing_label(fisheye_camera, tilted, DenseLabel::rays);
  int ahead = 0, behind = 0;
  double worst_px = 0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) {
      const Eigen::Vector3d ray = ray_at(rays, x, y);
      CHECK(ray.norm() == Approx(1).epsilon(1e-6));
      if (ray.z() <= 0.01) {
        ++behind;
        continue;
      }
      ++ahead;
      worst_px = std::max(worst_px, (opencv_pixel(fisheye_camera, ray) - Eigen::Vector2d(x, y)).norm());
    }
  CHECK(worst_px < 1e-4);  // rays are floats
  CHECK(ahead > 7000);
  CHECK(behind > 100);
}

TEST_CASE(
    "up is where OpenCV's fisheye pixel of a rising point goes and latitude the ray's angle to the ground") {
  const OIIO::ImageBuf rays = bearing_label(fisheye_camera, tilted, DenseLabel::rays),
                       up = bearing_label(fisheye_camera, tilted, DenseLabel::up),
                       latitude = bearing_label(fisheye_camera, tilted, DenseLabel::latitude);
  double worst = 0, most_sideways = 0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) {
      const Eigen::Vector3d ray = ray_at(rays, x, y);
      CHECK(latitude.getchannel(x, y, 0, 0) == Approx(degrees(std::asin(-ray.dot(tilted)))).margin(1e-4));
      if (ray.z() <= 0.05) continue;
      const Eigen::Vector3d step = -1e-4 * tilted;
      const Eigen::Vector2d rise =
          (opencv_pixel(fisheye_camera, ray + step) - opencv_pixel(fisheye_camera, ray - step)).normalized();
      const Eigen::Vector2d found(up.getchannel(x, y, 0, 0), up.getchannel(x, y, 0, 1));
      worst = std::max(worst, (found - rise).norm());
      most_sideways = std::max(most_sideways, std::abs(found.x()));
    }
  CHECK(worst < 1e-4);
  CHECK(most_sideways > 0.5);
}

TEST_CASE("where a fisheye shows nothing its bearings are 0") {
  const ModelCamera camera{"", {80, 80, 10, 10, 39.5, 39.5}, KannalaBrandt{}};  // a circle of 31.4 px
  for (const DenseLabel label : {DenseLabel::rays, DenseLabel::up, DenseLabel::latitude}) {
    const OIIO::ImageBuf image = bearing_label(camera, tilted, label);
    for (int y = 0; y < 80; y += 3)
      for (int x = 0; x < 80; x += 3) {
        const double radius = std::hypot(x - 39.5, y - 39.5);
        double length = 0;
        for (int c = 0; c < image.nchannels(); ++c) length += std::abs(image.getchannel(x, y, 0, c));
        if (radius > 10 * std::numbers::pi + 0.01) CHECK(length == 0);
        if (radius < 10 * std::numbers::pi - 0.01) CHECK(length > 0);
      }
  }
}

TEST_CASE("a Brown-Conrady camera has the same bearings as one of any family") {
  const CalibratedCamera camera{
      .name = "", .pinhole = pinhole_from_hfov(64, 48, radians(80)), .distortion = {.k1 = -0.1, .p1 = 0.002}};
  for (const DenseLabel label : {DenseLabel::rays, DenseLabel::up, DenseLabel::latitude}) {
    const OIIO::ImageBuf direct = bearing_label(camera, tilted, label),
                         any = bearing_label(model_camera(camera), tilted, label);
    CHECK(std::memcmp(direct.localpixels(), any.localpixels(), direct.spec().image_bytes()) == 0);
  }
  CHECK_THROWS_WITH(bearing_label(fisheye_camera, tilted, DenseLabel::depth),
                    Catch::StartsWith("depth: does not follow from the camera"));
}
