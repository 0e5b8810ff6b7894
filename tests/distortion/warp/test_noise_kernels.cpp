#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "distortion/warp/noise_kernels.h"
#include "distortion/warp/straight_exp.h"
#include "random/counter_hash.h"
#include "tests/distortion/warp/slow_warp.h"

using namespace cps;

namespace {

/// A kernel's covariance with variances between that of the narrowest kernel and `widest`, or a circle.
Eigen::Matrix2d random_covariance(Stream stream, double widest, bool circle) {
  constexpr double narrowest = narrowest_sigma_px * narrowest_sigma_px;
  const double first = narrowest * std::pow(widest / narrowest, random_uniform(stream, 0));
  const double second = circle ? first : narrowest * std::pow(widest / narrowest, random_uniform(stream, 1));
  const Eigen::Rotation2Dd turn(random_uniform(stream, 2, 0, std::numbers::pi));
  return turn.toRotationMatrix() * Eigen::Vector2d(first, second).asDiagonal() *
         turn.toRotationMatrix().transpose();
}

}  // namespace

TEST_CASE("straight-line exp and log agree with the library's to the last places") {
  const Stream stream = make_stream(31, "arguments");
  double worst_exp = 0, worst_log = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = random_uniform(stream, 2 * i, -700, 700);
    worst_exp = std::max(worst_exp, std::abs(straight_exp(x) / std::exp(x) - 1));
    const double power = random_uniform(stream, 2 * i + 1, -700, 700);
    const double y = std::abs(power) < 0.07 ? 0.5 : std::exp(power);
    worst_log = std::max(worst_log, std::abs(straight_log(y) / std::log(y) - 1));
  }
  CHECK(worst_exp < 5e-16);
  CHECK(worst_log < 5e-16);
  CHECK(straight_exp(0) == 1);
}

TEST_CASE("a row of noise kernels is what the derivation says, one pixel at a time") {
  const Stream stream = make_stream(32, "kernels");
  int with_noise = 0, without = 0;
  for (const double sigma_px : {0.3, 0.5, 0.8, 2.0})
    for (int trial = 0; trial < 100; ++trial) {
      const Stream of_row = substream(stream, trial);
      const int count = 1 + int(random_below(of_row, 0, KernelRow::side));
      KernelRow picture{};
      for (int i = 0; i < count; ++i)
        set_kernel(picture, i, random_covariance(substream(of_row, i), 30, i % 7 == 3));
      WeightedKernelRow noise;
      make_noise_kernels(NoiseTarget(sigma_px), picture, count, noise);
      for (int i = 0; i < count; ++i) {
        Eigen::Matrix2d conic;
        conic << picture.conic_xx[i], picture.conic_xy[i], picture.conic_xy[i], picture.conic_yy[i];
        const Eigen::Matrix2d covariance = conic.inverse() / (kernel_support * kernel_support);
        const SlowNoiseKernel expected = slow_noise_kernel(covariance, sigma_px);
        INFO("sigma " << sigma_px << ", trial " << trial << ", pixel " << i << ": " << covariance);
        REQUIRE(noise.weight[i] == Approx(expected.weight).epsilon(1e-6).margin(1e-6));
        if (expected.weight < 1e-4) {
          ++without;
          continue;
        }
        ++with_noise;
        KernelRow one{};
        set_kernel(one, 0, expected.covariance);
        const double size = one.conic_xx[0] + one.conic_yy[0];
        REQUIRE(noise.kernels.conic_xx[i] == Approx(one.conic_xx[0]).margin(2e-6 * size));
        REQUIRE(noise.kernels.conic_xy[i] == Approx(one.conic_xy[0]).margin(2e-6 * size));
        REQUIRE(noise.kernels.conic_yy[i] == Approx(one.conic_yy[0]).margin(2e-6 * size));
        REQUIRE(noise.kernels.half_width[i] == Approx(one.half_width[0]).epsilon(1e-5));
        REQUIRE(noise.kernels.half_height[i] == Approx(one.half_height[0]).epsilon(1e-5));
        // The noise's ellipse lies inside the picture's, up to the rounding of elongated conics.
        REQUIRE(noise.kernels.half_width[i] <= picture.half_width[i] * (1 + 1e-4f));
        REQUIRE(noise.kernels.half_height[i] <= picture.half_height[i] * (1 + 1e-4f));
      }
    }
  CHECK(with_noise > 1000);
  CHECK(without > 1000);
}
