#include <Eigen/Eigenvalues>
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "distortion/certificate/certificate.h"
#include "distortion/certificate/radial_limit.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

/// Range of the Jacobian's eigenvalues on a dense grid of the rectangle.
Range eigenvalues_on_grid(const Distortion& lens, const Eigen::AlignedBox2d& box, int steps) {
  Range range;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const Eigen::Vector2d at =
          box.min() + box.sizes().cwiseProduct(Eigen::Vector2d(double(i) / steps, double(j) / steps));
      const Eigen::Matrix2d J = distortion_jacobian(lens, at);
      const double mean = 0.5 * J.trace(), spread = std::hypot(0.5 * (J(0, 0) - J(1, 1)), J(0, 1));
      range.low = std::min(range.low, mean - spread);
      range.high = std::max(range.high, mean + spread);
    }
  return range;
}

struct Tally {
  int lenses = 0, truly_valid = 0, certified = 0, false_valid = 0, unsound_bounds = 0, disagreeing = 0;
  double loosest = 0;
};

/// Compares certificates with a grid search; half of the rectangles are not centred on the principal point.
Tally compare_with_grid(int lenses, int steps) {
  const Stream stream = make_stream(3, "certificate");
  const CertificateOptions options;
  Tally tally;
  for (int i = 0; i < lenses; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = i % 2 ? random_lens(stream, i, camera) : wild_lens(stream, i, camera);
    Eigen::AlignedBox2d box = frame_on_plane(camera);
    if (i % 4 < 2) box.translate(0.8 * random_point(substream(stream, i), 3, box));
    const Certificate certificate = certify(lens, box, options);
    const Range grid = eigenvalues_on_grid(lens, box, steps);
    const bool grid_valid = grid.low >= options.min_eigenvalue && grid.high <= options.max_eigenvalue;
    const double rounding = 1e-12;
    ++tally.lenses;
    tally.truly_valid += grid_valid;
    tally.certified += grid_valid && certificate.valid;
    tally.false_valid += certificate.valid && !grid_valid;
    tally.unsound_bounds +=
        certificate.min_eigenvalue > grid.low + rounding || certificate.max_eigenvalue < grid.high - rounding;
    tally.disagreeing += certificate.valid != is_certified(lens, box, options);
    tally.loosest = std::max(
        {tally.loosest, grid.low - certificate.min_eigenvalue, certificate.max_eigenvalue - grid.high});
  }
  return tally;
}

void check(const Tally& tally) {
  INFO(tally.certified << " certified of " << tally.truly_valid << " valid of " << tally.lenses
                       << ", bounds loose by " << tally.loosest);
  CHECK(tally.truly_valid > tally.lenses / 20);
  CHECK(tally.truly_valid < tally.lenses / 2);
  CHECK(tally.false_valid == 0);
  CHECK(tally.unsound_bounds == 0);
  CHECK(tally.disagreeing == 0);
  CHECK(tally.certified >= 0.99 * tally.truly_valid);
}

}  // namespace

TEST_CASE("the certificate accepts no lens that a dense search refutes, and at least 99 % of the others") {
  check(compare_with_grid(2000, 120));
}

TEST_CASE("certificate against dense search, 100,000 lenses", "[slow]") {
  const Tally tally = compare_with_grid(100'000, 150);
  WARN(tally.certified << " certified of " << tally.truly_valid << " that the grid finds valid, of "
                       << tally.lenses << "; false valid " << tally.false_valid << "; bounds loose by "
                       << tally.loosest);
  check(tally);
}

TEST_CASE("closed forms: one coefficient at a time") {
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-0.8, -0.6), Eigen::Vector2d(0.8, 0.6));  // corner radius 1
  const Certificate barrel = certify({.k1 = -0.2}, box);
  CHECK(barrel.min_eigenvalue == Approx(0.4).margin(2e-5));  // g(1) = 1 + 3 k1
  CHECK(barrel.max_eigenvalue == Approx(1.0).margin(2e-5));
  CHECK(barrel.witness_radius == Approx(1).margin(1e-6));
  CHECK(barrel.largest_scale == Approx(0.85 / 0.6).margin(1e-5));
  const Certificate none = certify({}, box);
  CHECK(none.valid);
  CHECK(none.min_eigenvalue == Approx(1).margin(1e-11));
  CHECK(none.largest_scale > 1e6);
  // p1 alone: J = I + 2 p1 [[y, x], [x, 3y]] has eigenvalues 1 + 2 p1 (2y ± r), smallest and largest at
  // corners.
  const Certificate tangential = certify({.p1 = 0.1}, box);
  CHECK(tangential.min_eigenvalue == Approx(1 - 0.2 * (1.2 + 1)).margin(2e-5));
  CHECK(tangential.max_eigenvalue == Approx(1 + 0.2 * (1.2 + 1)).margin(2e-5));
}

TEST_CASE("the largest scale is where the scaled lens stops being certified") {
  const Stream stream = make_stream(4, "scale");
  for (int i = 0; i < 300; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = wild_lens(stream, i, camera);
    const auto box = frame_on_plane(camera);
    const double t = certify(lens, box).largest_scale;
    const auto scaled = [&](double s) {
      return Distortion{s * lens.k1, s * lens.k2, s * lens.k3, s * lens.p1, s * lens.p2};
    };
    CHECK(is_certified(scaled(t * (1 - 1e-9)), box));
    CHECK_FALSE(is_certified(scaled(t * (1 + 1e-4)), box));
  }
}

TEST_CASE("a refusal names radius, eigenvalue and dominant term") {
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-0.8, -0.6), Eigen::Vector2d(0.8, 0.6));
  const Certificate folded = certify({.k1 = -0.5}, box);
  CHECK_FALSE(folded.valid);
  CHECK_THAT(folded.why, Catch::Contains("radius 1") && Catch::Contains("folds") && Catch::Contains("k1"));
  CHECK_THAT(certify({.k1 = 0.1, .p2 = 0.4}, box).why, Catch::Contains("p1, p2"));
  CHECK_THAT(certify({.k2 = 0.3}, box).why, Catch::Contains("largest") && Catch::Contains("k2"));
  CHECK_FALSE(certify({.k1 = std::nan("")}, box).valid);
  CHECK_FALSE(is_certified({.k3 = std::numeric_limits<double>::infinity()}, box));
  CHECK_FALSE(certify({}, Eigen::AlignedBox2d()).valid);
  CHECK_FALSE(certify({.k1 = 1e300, .k2 = -1e300}, box).valid);
}

TEST_CASE("unusable options are named") {
  CHECK_THAT(CertificateOptions{.min_eigenvalue = 0}.fault(), Catch::StartsWith("min_eigenvalue: "));
  CHECK_THAT(CertificateOptions{.max_eigenvalue = 0.9}.fault(), Catch::StartsWith("max_eigenvalue: "));
  CHECK(CertificateOptions{}.fault() == "");
}

TEST_CASE("the radial limit is the first radius where the radial slope vanishes") {
  const Stream stream = make_stream(5, "radial limit");
  int limited = 0;
  for (int i = 0; i < 2000; ++i) {
    const Distortion lens{random_normal(stream, 3 * i), random_normal(stream, 3 * i + 1),
                          random_normal(stream, 3 * i + 2)};
    const double limit = radial_limit(lens);
    const auto slope = [&](double r) {
      const double s = r * r;
      return 1 + s * (3 * lens.k1 + s * (5 * lens.k2 + s * 7 * lens.k3));
    };
    const double last = std::min(limit, 20.0);
    for (int k = 0; k < 400; ++k) CHECK(slope(last * (k + 0.5) / 400) > -1e-9);
    if (limit < 20) {
      ++limited;
      const double s = limit * limit;
      const double size =
          1 + std::abs(3 * lens.k1 * s) + std::abs(5 * lens.k2 * s * s) + std::abs(7 * lens.k3 * s * s * s);
      CHECK(std::abs(slope(limit)) < 1e-12 * size);
    }
  }
  CHECK(limited > 1000);
  CHECK(radial_limit({.k1 = -1.0 / 3}) == Approx(1));
  CHECK(std::isinf(radial_limit({})));
  CHECK(std::isinf(radial_limit({.k1 = 0.5})));
  CHECK(radial_limit({.k3 = -1.0 / 7}) == Approx(1));
}
