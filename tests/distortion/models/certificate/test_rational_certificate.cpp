#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "distortion/certificate/rim_gauge.h"
#include "distortion/models/certificate/rational_certificate.h"
#include "numbers/interval.h"
#include "tests/distortion/models/random_models.h"
#include "tests/distortion/random_lens.h"

using namespace cps;

namespace {

const Eigen::AlignedBox2d unit_box(Eigen::Vector2d(-0.8, -0.6), Eigen::Vector2d(0.8, 0.6));  // corner at 1

/// A rational lens in units of the camera's half diagonal.
RationalLens random_rational(Stream stream, int i, const Pinhole& camera) {
  const RationalLens scaled = std::get<RationalLens>(random_model(1, stream, i));
  const double unit = 1 / (0.5 * frame_on_plane(camera).diagonal().norm());
  const Distortion n = rescaled(Distortion{scaled.k1, scaled.k2, scaled.k3, scaled.p1, scaled.p2}, unit),
                   d = rescaled(Distortion{scaled.k4, scaled.k5, scaled.k6}, unit);
  return {n.k1, n.k2, n.k3, d.k1, d.k2, d.k3, n.p1, n.p2};
}

double denominator(const RationalLens& lens, double s) {
  return 1 + s * (lens.k4 + s * (lens.k5 + s * lens.k6));
}

/// Range of the Jacobian's eigenvalues on a dense grid of the rectangle; everything if D is not positive.
Interval eigenvalues_on_grid(const RationalLens& lens, const Eigen::AlignedBox2d& box, int steps) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Interval range{infinity, -infinity};
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const Eigen::Vector2d at =
          box.min() + box.sizes().cwiseProduct(Eigen::Vector2d(double(i) / steps, double(j) / steps));
      if (!(denominator(lens, at.squaredNorm()) > 0)) return {-infinity, infinity};
      const DistortedPoint J = evaluate(lens, at.x(), at.y());
      const double mean = 0.5 * (J.xx + J.yy), spread = std::hypot(0.5 * (J.xx - J.yy), J.xy);
      range = {std::min(range.low, mean - spread), std::max(range.high, mean + spread)};
    }
  return range;
}

struct RationalTally {
  int lenses = 0, valid = 0, clearly_valid = 0, missed = 0, false_valid = 0, unsound_bounds = 0,
      disagreeing = 0;
  double loosest = 0;
};

/// Compares certificates with a grid search; half of the rectangles are not centred on the principal point.
RationalTally compare_with_grid(int lenses, int steps) {
  const Stream stream = make_stream(43, "rational certificate");
  const CertificateOptions options;
  RationalTally tally;
  for (int i = 0; i < lenses; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const RationalLens lens = random_rational(stream, i, camera);
    Eigen::AlignedBox2d box = frame_on_plane(camera);
    if (i % 4 < 2) box.translate(0.8 * random_point(substream(stream, i), 30, box));
    const Certificate certificate = certify(lens, box, options);
    const Interval grid = eigenvalues_on_grid(lens, box, steps);
    const bool grid_valid = grid.low >= options.min_eigenvalue && grid.high <= options.max_eigenvalue;
    const bool is_clear =
        grid.low >= options.min_eigenvalue + 0.01 && grid.high <= options.max_eigenvalue - 0.02;
    ++tally.lenses;
    tally.valid += certificate.valid;
    tally.clearly_valid += is_clear;
    tally.missed += is_clear && !certificate.valid;
    tally.false_valid += certificate.valid && !grid_valid;
    tally.disagreeing += certificate.valid != is_certified(lens, box, options);
    if (!certificate.valid) continue;
    tally.unsound_bounds +=
        certificate.min_eigenvalue > grid.low + 1e-12 || certificate.max_eigenvalue < grid.high - 1e-12;
    tally.loosest = std::max(
        {tally.loosest, grid.low - certificate.min_eigenvalue, certificate.max_eigenvalue - grid.high});
  }
  return tally;
}

void check(const RationalTally& tally) {
  INFO(tally.valid << " valid of " << tally.lenses << ", " << tally.missed << " missed of "
                   << tally.clearly_valid << ", bounds loose by " << tally.loosest);
  CHECK(tally.clearly_valid > tally.lenses / 10);
  CHECK(tally.valid < tally.lenses * 9 / 10);
  CHECK(tally.false_valid == 0);
  CHECK(tally.unsound_bounds == 0);
  CHECK(tally.disagreeing == 0);
  CHECK(tally.missed <= tally.clearly_valid / 1000);
  CHECK(tally.loosest < 0.1);  // of the grid, mostly
}

}  // namespace

TEST_CASE("rational: the certificate accepts no lens that a dense search refutes, and 99.9 % of the others") {
  check(compare_with_grid(10'000, 40));
}

TEST_CASE("rational certificate against dense search, 100,000 lenses", "[slow]") {
  check(compare_with_grid(100'000, 100));
}

TEST_CASE("without a denominator the rational certificate is Brown–Conrady's") {
  const Stream stream = make_stream(44, "no denominator");
  const auto as_rational = [](const Distortion& lens) {
    return RationalLens{.k1 = lens.k1, .k2 = lens.k2, .k3 = lens.k3, .p1 = lens.p1, .p2 = lens.p2};
  };
  for (int i = 0; i < 1000; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = i % 2 ? random_lens(stream, i, camera) : wild_lens(stream, i, camera);
    Eigen::AlignedBox2d box = frame_on_plane(camera);
    if (i % 4 < 2) box.translate(0.5 * random_point(substream(stream, i), 3, box));
    const Certificate rational = certify(as_rational(lens), box), plain = certify(lens, box);
    CHECK(rational.valid == plain.valid);
    CHECK(rational.min_eigenvalue == Approx(plain.min_eigenvalue).margin(1.1e-5));
    CHECK(rational.max_eigenvalue == Approx(plain.max_eigenvalue).margin(1.1e-5));
  }
  for (int i = 0; i < 40; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = random_lens(stream, i, camera);
    const FrameCertificate rational = certify_frame(as_rational(lens), camera, one_to_one),
                           plain = certify_frame(lens, camera, one_to_one);
    CHECK(rational.valid() == plain.valid());
    CHECK(rational.rectangle.isApprox(plain.rectangle, 1e-7));
  }
}

TEST_CASE("rational lenses in closed form") {
  // x / (1 + k r²): R = 1 / (1 + k s), g = (1 − k s) / (1 + k s)².
  const Certificate division = certify(RationalLens{.k4 = 0.2}, unit_box);
  CHECK(division.valid);
  CHECK(division.min_eigenvalue == Approx(0.8 / 1.44).margin(2e-5));
  CHECK(division.max_eigenvalue == Approx(1).margin(2e-5));
  CHECK(division.witness_radius == Approx(1).margin(1e-6));
  // It folds where k s = 1.
  const Certificate folded = certify(RationalLens{.k4 = 1.5}, unit_box, one_to_one);
  CHECK_FALSE(folded.valid);
  CHECK_THAT(folded.why, Catch::Contains("folds"));
  // Equal numerator and denominator are no lens at all.
  const Certificate none = certify(RationalLens{7, 3, 1, 7, 3, 1}, unit_box);
  CHECK(none.valid);
  CHECK(none.min_eigenvalue == Approx(1).margin(2e-5));
  CHECK(none.max_eigenvalue == Approx(1).margin(2e-5));
}

TEST_CASE("a pole inside the rectangle is refused with its radius") {
  const RationalLens pole{.k4 = -4};  // 1 − 4 r²
  const Certificate certificate = certify(pole, unit_box, one_to_one);
  CHECK_FALSE(certificate.valid);
  CHECK(certificate.witness_radius == Approx(0.5).margin(1e-6));
  CHECK_THAT(certificate.why, Catch::Contains("radius 0.5") && Catch::Contains("denominator"));
  CHECK_FALSE(is_certified(pole, unit_box, one_to_one));
  // A double pole that the numerator cancels: nothing can be evaluated there.
  CHECK_FALSE(is_certified(RationalLens{.k1 = -8, .k2 = 16, .k4 = -8, .k5 = 16}, unit_box, one_to_one));
  // The radius grows without bound towards a pole, so the frame is reached before it.
  CHECK(certify_frame(pole, pinhole_from_hfov(480, 480, radians(60)), one_to_one).valid());
  // With a numerator that falls as fast, the frame is not reached.
  const RationalLens cancelled{.k1 = -4.0001, .k4 = -4};
  CHECK_FALSE(certify_frame(cancelled, pinhole_from_hfov(640, 480, radians(90)), one_to_one).valid());
  CHECK_FALSE(certify(RationalLens{.k5 = std::nan("")}, unit_box).valid);
  CHECK_FALSE(is_certified(RationalLens{.k6 = std::numeric_limits<double>::infinity()}, unit_box));
  CHECK_FALSE(certify(RationalLens{.k1 = 1e300, .k4 = 1e300, .k5 = -1e300}, unit_box).valid);
}

TEST_CASE("a rational lens is certified on every part of a certified rectangle") {
  const Stream stream = make_stream(45, "parts");
  int certified = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const RationalLens lens = random_rational(stream, i, camera);
    const Eigen::AlignedBox2d box = frame_on_plane(camera);
    if (!is_certified(lens, box)) continue;
    ++certified;
    const auto share = [&](int k) { return random_uniform(substream(stream, i), 40 + k, 0.1, 1); };
    CHECK(is_certified(lens, {box.min().cwiseProduct(Eigen::Vector2d(share(0), share(1))),
                              box.max().cwiseProduct(Eigen::Vector2d(share(2), share(3)))}));
  }
  CHECK(certified > 200);
}

TEST_CASE("the rim gauge of a rational lens is a lower bound, and a tight one") {
  const Stream stream = make_stream(46, "rim");
  for (int i = 0; i < 200; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const RationalLens lens = random_rational(stream, i, camera);
    const Eigen::AlignedBox2d box = frame_on_plane(camera);
    if (!is_certified(lens, box)) continue;
    double sampled = std::numeric_limits<double>::infinity();
    constexpr int steps = 500;
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector2d along = box.min() + box.sizes() * k / steps;
      for (const Eigen::Vector2d& point :
           {Eigen::Vector2d(along.x(), box.min().y()), Eigen::Vector2d(along.x(), box.max().y()),
            Eigen::Vector2d(box.min().x(), along.y()), Eigen::Vector2d(box.max().x(), along.y())}) {
        const DistortedPoint at = evaluate(lens, point.x(), point.y());
        sampled = std::min(sampled, gauge(box, {at.x, at.y}));
      }
    }
    const double bound = smallest_rim_gauge(lens, box, box);
    CHECK(bound <= sampled * (1 + 1e-12));
    CHECK(bound > sampled - 0.005);  // of the samples' distance
  }
}
