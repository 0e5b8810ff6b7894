#include <tbb/global_control.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "distortion/panorama/equirectangular.h"
#include "distortion/panorama/panorama_warp.h"
#include "distortion/warp/footprints.h"
#include "numbers/angles.h"
#include "random/counter_hash.h"
#include "tests/distortion/models/family_cameras.h"
#include "tests/same_bytes.h"

using namespace cps;

namespace {

const WarpOptions any_resolution{.require_resolution = false};

OIIO::ImageBuf noise_picture(const Panorama& size, int channels) {
  OIIO::ImageBuf image(OIIO::ImageSpec(size.width, size.height, channels, OIIO::TypeFloat));
  float* values = static_cast<float*>(image.localpixels());
  for (std::size_t i = 0; i < image.spec().image_pixels() * channels; ++i)
    values[i] = float(random_uniform(make_stream(62, "panorama"), i));
  return image;
}

/// Straight ahead, at the seam, at either pole, and slightly off them.
struct Pose {
  double yaw_deg, pitch_deg, roll_deg;
  Eigen::Matrix3d rotation() const {
    return panorama_from_camera(radians(yaw_deg), radians(pitch_deg), radians(roll_deg));
  }
};
constexpr Pose poses[]{{0, 0, 0},    {180, 5, -20}, {-171, -40, 10},
                       {17, 90, 12}, {40, -90, 0},  {-120, 84, 100}};

/// A camera of one pixel, `focal` pixels per radian.
ModelCamera single_pixel(double focal) {
  return {"", {1, 1, focal, focal, 0, 0}, Distortion{}};
}

/// The warp's mean by the book: over all pixels of the half sphere about the ray, with matrices, and with
/// derivatives by differences.
double slow_pixel(const OIIO::ImageBuf& panorama, const Eigen::Matrix3d& rotation, const ModelCamera& camera,
                  const RayRegion& region, double sigma_px, const Eigen::Vector2d& at) {
  const Panorama size{panorama.spec().width, panorama.spec().height};
  const double per_rad = size.width / (2 * std::numbers::pi);
  const auto seen = [&](double dx, double dy) -> Eigen::Vector3d {
    return rotation * ray_at(camera, region, at + Eigen::Vector2d(dx, dy));
  };
  const Eigen::Vector3d centre = seen(0, 0);
  Eigen::Vector3d east = Eigen::Vector3d::UnitY().cross(centre);
  east = east.norm() > 1e-9 ? Eigen::Vector3d(east.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  Eigen::Matrix<double, 2, 3> to_plane;  // of a direction, in pixels of the equator
  to_plane << per_rad * east.transpose(), per_rad * centre.cross(east).transpose();
  const double step = 1e-3;
  Eigen::Matrix2d jacobian;
  jacobian << to_plane * (seen(step, 0) - seen(-step, 0)) / (2 * step),
      to_plane * (seen(0, step) - seen(0, -step)) / (2 * step);
  const double cosine2 = 1 - centre.y() * centre.y();
  Eigen::Matrix2d covariance = sigma_px * sigma_px * jacobian * jacobian.transpose();
  covariance.diagonal() -= Eigen::Vector2d(cosine2, 1.0) / 12;
  const double smallest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues().minCoeff();
  covariance.diagonal().array() += std::max(0.0, narrowest_sigma_px * narrowest_sigma_px - smallest);
  const Eigen::Matrix2d conic = covariance.inverse() / (kernel_support * kernel_support);

  double sum = 0, weights = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const Eigen::Vector3d pixel = direction(size, {x, y});
      if (pixel.dot(centre) <= 0) continue;
      const Eigen::Vector2d offset = to_plane * pixel;
      const double inside = 1 - offset.dot(conic * offset);
      if (inside <= 0) continue;
      const double weight = inside * inside * inside * std::cos(latitude_rad(size, y));
      weights += weight;
      sum += weight * panorama.getchannel(x, y, 0, 0);
    }
  return sum / weights;
}

}  // namespace

TEST_CASE("yaw turns to the right and pitch up and roll clockwise") {
  const Eigen::Vector3d right = Eigen::Vector3d::UnitX(), down = Eigen::Vector3d::UnitY(),
                        ahead = Eigen::Vector3d::UnitZ();
  CHECK((panorama_from_camera(radians(90), 0, 0) * ahead - right).norm() < 1e-15);
  CHECK((panorama_from_camera(0, radians(90), 0) * ahead + down).norm() < 1e-15);
  CHECK((panorama_from_camera(0, 0, radians(90)) * right - down).norm() < 1e-15);
  // The world's up turns counter-clockwise in the picture: to its upper left.
  const Eigen::Vector3d up = panorama_from_camera(0, 0, radians(30)).transpose() * -down;
  CHECK((up - Eigen::Vector3d(-std::sin(radians(30)), -std::cos(radians(30)), 0)).norm() < 1e-15);
  const double yaw = 0.7, pitch = -0.4;
  for (const double roll : {0.0, 1.1}) {
    const Eigen::Matrix3d rotation = panorama_from_camera(yaw, pitch, roll);
    CHECK((rotation * ahead - Eigen::Vector3d(std::sin(yaw) * std::cos(pitch), -std::sin(pitch),
                                              std::cos(yaw) * std::cos(pitch)))
              .norm() < 1e-15);
    CHECK(rotation.determinant() == Approx(1));
    // Without roll the camera's right is level; the roll lowers it by its own angle.
    CHECK((rotation * right).y() == Approx(std::sin(roll) * std::cos(pitch)));
  }
}

TEST_CASE("a bright spot appears where the camera's turn puts it") {
  const Panorama size{720, 360};
  OIIO::ImageBuf panorama(OIIO::ImageSpec(size.width, size.height, 1, OIIO::TypeFloat));
  const auto light = [&](double longitude_deg, double latitude_deg) {
    std::fill_n(static_cast<float*>(panorama.localpixels()), panorama.spec().image_pixels(), 0.0f);
    const int x = int(2 * (longitude_deg + 180)), y = int(2 * (90 - latitude_deg));
    for (const int dx : {-1, 0})
      for (const int dy : {-1, 0}) *static_cast<float*>(panorama.pixeladdr(x + dx, y + dy)) = 1;
  };
  const ModelCamera camera{"", {101, 101, 80, 80, 50, 50}, KannalaBrandt{}};
  const auto brightest = [&](const Pose& pose) {
    const auto image = photograph_panorama(panorama, pose.rotation(), camera, any_resolution);
    Eigen::Vector2d at(0, 0);
    for (int y = 0; y < 101; ++y)
      for (int x = 0; x < 101; ++x)
        if (image.getchannel(x, y, 0, 0) > image.getchannel(int(at.x()), int(at.y()), 0, 0)) at = {x, y};
    return at;
  };
  light(40, 20);
  CHECK((brightest({40, 20, 0}) == Eigen::Vector2d(50, 50)));
  CHECK((brightest({40, 20, 77}) == Eigen::Vector2d(50, 50)));
  const double px_per_10_deg = 80 * radians(10);
  CHECK((brightest({40, 30, 0}) - Eigen::Vector2d(50, 50 + px_per_10_deg)).norm() < 1);
  light(10, 0);
  CHECK((brightest({0, 0, 0}) - Eigen::Vector2d(50 + px_per_10_deg, 50)).norm() < 1);
  CHECK((brightest({0, 0, 90}) - Eigen::Vector2d(50, 50 - px_per_10_deg)).norm() < 1);
  light(175, 0);
  CHECK((brightest({-175, 0, 0}) - Eigen::Vector2d(50 - px_per_10_deg, 50)).norm() < 1);
}

TEST_CASE("a constant panorama gives exactly that constant even at the poles") {
  const std::array<float, 3> colour{0.3f, 1e-3f, 700.1f};
  OIIO::ImageBuf panorama(OIIO::ImageSpec(256, 128, 3, OIIO::TypeFloat));
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x)
      std::copy(colour.begin(), colour.end(), static_cast<float*>(panorama.pixeladdr(x, y)));
  const ModelCamera wide{"", {101, 101, 30, 30, 50, 50}, KannalaBrandt{}};  // up to 135° off the axis
  for (const Pose& pose : poses) {
    WarpSummary summary;
    const auto image = photograph_panorama(panorama, pose.rotation(), wide, any_resolution, &summary);
    CHECK(summary.uncovered_pixels == 0);
    for (int y = 0; y < 101; ++y)
      for (int x = 0; x < 101; ++x)
        for (int channel = 0; channel < 3; ++channel)
          REQUIRE(image.getchannel(x, y, 0, channel) == colour[channel]);
  }
}

TEST_CASE("a photograph of a panorama is the kernel's mean over the sphere") {
  const auto panorama = noise_picture({128, 64}, 1);
  for (const ModelCamera& camera : family_cameras(18, 14, 13)) {
    const RayRegion region = proved_region(camera);
    for (const Pose& pose : poses) {
      const Eigen::Matrix3d rotation = pose.rotation();
      const auto image = photograph_panorama(panorama, rotation, camera, any_resolution);
      for (int y = 0; y < 14; y += 2)
        for (int x = y % 4 / 2; x < 18; x += 2) {
          INFO(camera.name << ", yaw " << pose.yaw_deg << ", pitch " << pose.pitch_deg << ": " << x << ", "
                           << y);
          // Derivatives by differences are exact to 1e-6.
          REQUIRE(image.getchannel(x, y, 0, 0) ==
                  Approx(slow_pixel(panorama, rotation, camera, region, 0.5, {x, y})).margin(2e-6));
        }
    }
  }
  // Straight at the poles, where x has no direction of its own.
  for (const double pitch_deg : {90.0, -90.0}) {
    const ModelCamera camera = single_pixel(9);
    const Eigen::Matrix3d rotation = Pose{0, pitch_deg, 0}.rotation();
    CHECK(photograph_panorama(panorama, rotation, camera, any_resolution).getchannel(0, 0, 0, 0) ==
          Approx(slow_pixel(panorama, rotation, camera, proved_region(camera), 0.5, {0, 0})).margin(2e-6));
  }
}

TEST_CASE("a smooth world is photographed as it is by every family in every direction") {
  const Panorama size{512, 256};
  OIIO::ImageBuf panorama(OIIO::ImageSpec(size.width, size.height, 1, OIIO::TypeFloat));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      *static_cast<float*>(panorama.pixeladdr(x, y)) = float(smooth_scene(direction(size, {x, y})));
  for (const ModelCamera& camera : family_cameras(60, 44, 40)) {
    const RayRegion region = proved_region(camera);
    for (const Pose& pose : poses) {
      const Eigen::Matrix3d rotation = pose.rotation();
      WarpSummary summary;
      const auto image = photograph_panorama(panorama, rotation, camera, any_resolution, &summary);
      CHECK(summary.worst_residual_px < 1e-8);
      double worst = 0;
      for (int y = 0; y < 44; ++y)
        for (int x = 0; x < 60; ++x)
          worst = std::max(worst, std::abs(image.getchannel(x, y, 0, 0) -
                                           smooth_scene(rotation * ray_at(camera, region, {x, y}))));
      INFO(camera.name << ", yaw " << pose.yaw_deg << ", pitch " << pose.pitch_deg);
      // The kernel's variance of .25 px² blurs by at most ½ · .25 · 5 / 40² = .0004, and by up to twice as
      // much in the corners. A footprint that is .1 pixels off adds .003.
      CHECK(worst < 1e-3);
    }
  }
}

TEST_CASE("a yaw by whole pixels is a turned panorama") {
  const auto panorama = noise_picture({128, 64}, 2);
  OIIO::ImageBuf turned(panorama.spec());
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x)
      std::copy_n(static_cast<const float*>(panorama.pixeladdr((x + 50) % 128, y)), 2,
                  static_cast<float*>(turned.pixeladdr(x, y)));
  const ModelCamera camera = family_cameras(40, 30, 20)[2];
  const auto by_yaw = photograph_panorama(
      panorama, panorama_from_camera(2 * std::numbers::pi * 50 / 128, 0.9, 0.2), camera, any_resolution);
  const auto by_hand = photograph_panorama(turned, panorama_from_camera(0, 0.9, 0.2), camera, any_resolution);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      for (int channel = 0; channel < 2; ++channel)
        REQUIRE(by_yaw.getchannel(x, y, 0, channel) ==
                Approx(by_hand.getchannel(x, y, 0, channel)).margin(1e-6));
}

TEST_CASE("the narrowest kernel has a closed form") {
  const auto panorama = noise_picture({1024, 512}, 1);
  const double per_rad = 1024 / (2 * std::numbers::pi);
  for (const double pitch_deg : {0.0, 35.0, 90.0})
    for (const double focal : {40.0, 90.0}) {
      WarpSummary summary;
      photograph_panorama(panorama, Pose{10, pitch_deg, 0}.rotation(), single_pixel(focal), any_resolution,
                          &summary);
      const double size = per_rad / focal;  // of the output's pixel
      CHECK(summary.smallest_kernel_sigma_px ==
            Approx(std::sqrt(0.25 * size * size - 1.0 / 12)).epsilon(1e-9));
    }
}

TEST_CASE("pixel types and channels of a panorama do not matter") {
  const auto three = noise_picture({256, 128}, 3);
  const ModelCamera camera = family_cameras(40, 30, 30)[4];
  const Eigen::Matrix3d rotation = Pose{175, 60, 30}.rotation();
  const auto reference = photograph_panorama(three, rotation, camera);
  const auto halves = photograph_panorama(three.copy(OIIO::TypeHalf), rotation, camera);
  const auto bytes = photograph_panorama(three.copy(OIIO::TypeUInt8), rotation, camera);
  CHECK(halves.spec().format == OIIO::TypeHalf);
  CHECK(bytes.spec().format == OIIO::TypeUInt8);
  OIIO::ImageBuf one(OIIO::ImageSpec(256, 128, 1, OIIO::TypeFloat));
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) *static_cast<float*>(one.pixeladdr(x, y)) = three.getchannel(x, y, 0, 1);
  const auto single = photograph_panorama(one, rotation, camera);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const float expected = reference.getchannel(x, y, 0, 1);
      REQUIRE(single.getchannel(x, y, 0, 0) == expected);
      REQUIRE(std::abs(halves.getchannel(x, y, 0, 1) - expected) <= 1e-3f);
      REQUIRE(std::abs(bytes.getchannel(x, y, 0, 1) - expected) <= 1 / 255.0f);
    }
}

TEST_CASE("a photograph of a panorama has the same bytes for any number of threads") {
  const auto panorama = noise_picture({256, 128}, 3);
  const ModelCamera camera = family_cameras(150, 140, 60)[3];
  std::vector<OIIO::ImageBuf> images;
  for (const int threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    images.push_back(photograph_panorama(panorama, Pose{170, 70, 5}.rotation(), camera, any_resolution));
  }
  CHECK(same_bytes(images[0], images[1]));
  CHECK(same_bytes(images[0], images[2]));
}

TEST_CASE("a photograph of a panorama refuses unusable input in one line") {
  const ModelCamera camera = family_camera(KannalaBrandt{}, 60, 40, 25);
  const Eigen::Matrix3d ahead = Eigen::Matrix3d::Identity();
  const auto panorama = noise_picture({200, 100}, 1);
  CHECK_THROWS_WITH(photograph_panorama(noise_picture({200, 110}, 1), ahead, camera),
                    Catch::Contains("200 x 110") && Catch::Contains("twice as wide"));
  CHECK_THROWS_WITH(photograph_panorama(noise_picture({200, 100}, 5), ahead, camera),
                    Catch::Contains("channels"));
  CHECK_THROWS_WITH(photograph_panorama(OIIO::ImageBuf(), ahead, camera), Catch::Contains("memory"));
  CHECK_THROWS_WITH(photograph_panorama(panorama, ahead, camera, {.kernel_sigma_px = 9}),
                    Catch::Contains("kernel_sigma_px"));
  CHECK_THROWS_WITH(photograph_panorama(panorama, ahead, camera, {.resampling = Resampling::nearest}),
                    Catch::Contains("averaged"));
  CHECK_THROWS_WITH(photograph_panorama(panorama, ahead, family_camera(KannalaBrandt{}, 60, 40, 60)),
                    Catch::Contains("magnified"));
  CHECK_THROWS_WITH(
      photograph_panorama(panorama, ahead, family_camera(KannalaBrandt{.k1 = -0.3}, 60, 40, 25)),
      Catch::StartsWith("warp: "));
  ModelCamera empty = camera;
  empty.pinhole.width = 0;
  CHECK_THROWS_WITH(photograph_panorama(panorama, ahead, empty), Catch::Contains("positive"));
  // A pixel that sees more of the sphere than a kernel may reach has nothing to average.
  WarpSummary summary;
  WarpOptions partial;
  partial.require_coverage = false;
  const auto image = photograph_panorama(panorama, ahead, single_pixel(1), partial, &summary);
  CHECK((summary.uncovered_pixels == 1 && image.getchannel(0, 0, 0, 0) == 0));
}
