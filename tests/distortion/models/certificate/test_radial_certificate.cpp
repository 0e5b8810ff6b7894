#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/certificate/radial_certificate.h"
#include "distortion/models/certificate/sphere_reach.h"
#include "distortion/models/projection.h"
#include "numbers/interval.h"
#include "tests/distortion/models/random_models.h"

using namespace cps;
using std::numbers::pi;

namespace {

/// The papers' formulas, written down once more. Not positive or not a number: undefined.
double radius(const KannalaBrandt& lens, double t) {
  return t + lens.k1 * std::pow(t, 3) + lens.k2 * std::pow(t, 5) + lens.k3 * std::pow(t, 7) +
         lens.k4 * std::pow(t, 9);
}
double radius(const Eucm& lens, double t) {
  const double s = std::sin(t), c = std::cos(t);
  return s / (lens.alpha * std::sqrt(lens.beta * s * s + c * c) + (1 - lens.alpha) * c);
}
double radius(const DoubleSphere& lens, double t) {
  const double s = std::sin(t), w = lens.xi + std::cos(t);
  return s / (lens.alpha * std::sqrt(s * s + w * w) + (1 - lens.alpha) * w);
}

/// A camera of 1000 × 750 pixels whose farthest corner is at this radius of the normalised image, its
/// principal point off the middle.
Pinhole camera_with_corner(double corner_radius) {
  const double cx = 520, cy = 330, focal = std::hypot(520.5, 419.5) / corner_radius;
  return {1000, 750, focal, focal, cx, cy};
}

/// What 400 samples of the radius say about a lens.
struct Samples {
  std::vector<double> angles, radii;
  std::size_t growing = 0;  ///< index of the last sample before the radius first shrinks
};
template <typename Lens>
Samples sampled(const Lens& lens, double last_angle) {
  constexpr int steps = 400;
  Samples samples;
  for (int i = 0; i <= steps; ++i) {
    samples.angles.push_back(last_angle * i / steps);
    samples.radii.push_back(radius(lens, samples.angles.back()));
  }
  while (samples.growing < steps && samples.radii[samples.growing + 1] > samples.radii[samples.growing])
    ++samples.growing;
  return samples;
}

/// The smallest and the largest mean slope between samples: values that dr/dθ takes.
Interval mean_slopes(const Samples& samples, std::size_t count) {
  Interval slopes{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < count; ++i) {
    const double slope =
        (samples.radii[i + 1] - samples.radii[i]) / (samples.angles[i + 1] - samples.angles[i]);
    slopes = {std::min(slopes.low, slope), std::max(slopes.high, slope)};
  }
  return slopes;
}

struct RadialTally {
  int valid = 0, clearly_valid = 0, missed = 0, false_valid = 0, unsound_bounds = 0, short_regions = 0;
};

template <typename Lens>
RadialTally compare_with_samples(std::size_t family, int lenses) {
  const Stream stream = make_stream(41, "radial certificate");
  RadialTally tally;
  for (int i = 0; i < lenses; ++i) {
    const Lens lens = std::get<Lens>(random_model(family, stream, i));
    const double corner = std::exp(random_uniform(substream(stream, i), 50, std::log(0.2), std::log(4)));
    const ModelCertificate proof = certify_frame({"", camera_with_corner(corner), lens});
    tally.valid += proof.valid;

    const Samples within = sampled(lens, proof.region.max_angle_rad);
    const Interval seen = mean_slopes(within, within.angles.size() - 1);
    const double rounding = 1e-9 * std::max(1.0, proof.max_scale);
    tally.false_valid +=
        within.growing + 1 < within.angles.size() || (proof.valid && !(within.radii.back() >= corner));
    tally.unsound_bounds +=
        !(proof.min_scale <= seen.low + rounding && seen.high - rounding <= proof.max_scale);

    // Where the samples grow steeply the lens must be proved.
    const Samples all = sampled(lens, angle_limit(LensModel(lens)) - 1e-3);
    std::size_t steep = 0;
    while (steep < all.growing && all.radii[steep + 1] - all.radii[steep] > 1e-3 * all.angles[1]) ++steep;
    if (steep == 0) continue;
    if (all.radii[steep - 1] > 1.001 * corner) {
      ++tally.clearly_valid;
      tally.missed += !proof.valid;
    } else if (!proof.valid) {
      tally.short_regions += proof.region.max_angle_rad < all.angles[steep - 1];
    }
  }
  return tally;
}

void check(const RadialTally& tally, int lenses) {
  INFO(tally.valid << " valid, " << tally.clearly_valid << " clearly, " << tally.missed << " missed of "
                   << lenses);
  CHECK(tally.clearly_valid > lenses / 10);
  CHECK(tally.valid < lenses * 95 / 100);
  CHECK(tally.false_valid == 0);
  CHECK(tally.unsound_bounds == 0);
  CHECK(tally.short_regions == 0);
  CHECK(tally.missed <= tally.clearly_valid / 1000);
}

}  // namespace

TEST_CASE("kannala_brandt: no cone is proved where samples of the radius shrink; 99.9 % of the others are") {
  check(compare_with_samples<KannalaBrandt>(2, 10'000), 10'000);
}

TEST_CASE("eucm: no cone is proved where samples of the radius shrink; 99.9 % of the others are") {
  check(compare_with_samples<Eucm>(4, 10'000), 10'000);
}

TEST_CASE("double_sphere: no cone is proved where samples of the radius shrink; 99.9 % of the others are") {
  check(compare_with_samples<DoubleSphere>(5, 10'000), 10'000);
}

TEST_CASE("radial certificates against samples, 300,000 lenses", "[slow]") {
  check(compare_with_samples<KannalaBrandt>(2, 100'000), 100'000);
  check(compare_with_samples<Eucm>(4, 100'000), 100'000);
  check(compare_with_samples<DoubleSphere>(5, 100'000), 100'000);
}

TEST_CASE("slopes of known lenses") {
  const auto matches = [](const Interval& slope, double low, double high) {
    CHECK(slope.low <= low);
    CHECK(slope.high >= high);
    CHECK(slope.low == Approx(low).margin(2e-5));
    CHECK(slope.high == Approx(high).margin(2e-5));
  };
  matches(certify_cone(KannalaBrandt{}, 3).slope, 1, 1);
  matches(certify_cone(KannalaBrandt{.k1 = -0.05}, 2).slope, 1 - 0.15 * 4, 1);
  // 2 tan θ/2 and tan θ/2, the stereographic projection.
  matches(certify_cone(Eucm{.alpha = 0.5}, pi / 2).slope, 1, 2);
  matches(certify_cone(DoubleSphere{.xi = 1, .alpha = 0}, pi / 2).slope, 0.5, 1);
  // tan θ, and sin θ.
  matches(certify_cone(Eucm{.alpha = 0}, pi / 4).slope, 1, 2);
  matches(certify_cone(Eucm{.alpha = 1}, pi / 3).slope, 0.5, 1);
  CHECK(certify_cone(Eucm{.alpha = 1}, pi / 3).witness_angle_rad == Approx(pi / 3));
  CHECK(certify_cone(Eucm{.alpha = 0}, pi / 4).witness_angle_rad == Approx(0).margin(0.01));
}

TEST_CASE("a moustache is proved up to its first fold") {
  // 1 + 3 k1 s + 5 k2 s² has the roots s = 1 and s = 2.
  const KannalaBrandt lens{.k1 = -0.5, .k2 = 0.1};
  const double fold = largest_growing_angle(lens);
  CHECK(fold < 1);
  CHECK(fold == Approx(1).margin(1e-6));
  // The smallest slope of this one is 0.1, at s = 1.5.
  CHECK(largest_growing_angle(KannalaBrandt{.k1 = -0.4, .k2 = 0.08}) == Approx(pi).margin(2e-9));
  CHECK(certify_cone(KannalaBrandt{.k1 = -0.4, .k2 = 0.08}, 2).slope.low == Approx(0.1).margin(2e-5));
}

TEST_CASE("cones end at the families' limits") {
  CHECK(largest_growing_angle(Eucm{.alpha = 0}) == Approx(pi / 2).margin(2e-9));
  CHECK(largest_growing_angle(Eucm{.alpha = 0.6}) == Approx(std::acos(-0.4 / 0.6)).margin(1e-5));
  CHECK(largest_growing_angle(DoubleSphere{.xi = 0, .alpha = 0.3}) ==
        Approx(std::acos(-0.3 / 0.7)).margin(1e-5));
  for (const double xi : {0.3, 0.9, 1.0}) {
    CHECK(sphere_reach(xi).max_angle_rad == Approx(std::acos(-xi)).margin(1e-6));
    CHECK(sphere_reach(xi).max_radius > 1e6);
  }
  CHECK(sphere_reach(1.2).max_angle_rad < std::acos(-1 / 1.2));
  CHECK(sphere_reach(1.2).max_angle_rad == Approx(std::acos(-1 / 1.2)).margin(1e-6));
  CHECK(sphere_reach(1.2).max_radius == Approx(1 / std::sqrt(0.44)).epsilon(1e-12));
}

TEST_CASE("the angle on the sphere inverts the unified projection") {
  for (const double xi : {0.0, 0.4, 1.0, 1.2, 4.0}) {
    const double last = sphere_reach(xi).max_angle_rad;
    for (int i = 0; i < 100; ++i) {
      const double angle = 0.999 * last * i / 100;
      CHECK(angle_on_sphere(xi, std::sin(angle) / (std::cos(angle) + xi)) == Approx(angle).margin(1e-11));
    }
  }
}

TEST_CASE("the slopes of a part of a cone lie within those of the whole") {
  const Stream stream = make_stream(42, "nested cones");
  const auto check_nested = [&](const auto& lens, int i) {
    const auto draw = [&](int k) { return random_uniform(substream(stream, i), 60 + k); };
    const double low = 0.8 * draw(0), high = low + draw(1), inner_low = low + (high - low) * draw(2),
                 inner_high = inner_low + (high - inner_low) * draw(3);
    const Interval outer = radial_slopes(lens, low, high), inner = radial_slopes(lens, inner_low, inner_high);
    if (!std::isfinite(outer.low)) return;  // beyond the lens' limit
    CHECK(outer.low <= inner.low + 1e-9 * std::abs(inner.low));
    CHECK(outer.high >= inner.high - 1e-9 * std::abs(inner.high));
    const double middle = 0.5 * (inner_low + inner_high), step = 1e-5;
    const double slope = (radius(lens, middle + step) - radius(lens, middle - step)) / (2 * step);
    const Interval at = radial_slopes(lens, middle - step, middle + step);
    CHECK(std::clamp(slope, at.low, at.high) == Approx(slope).epsilon(1e-8).margin(1e-8));
  };
  for (int i = 0; i < 2000; ++i) {
    check_nested(std::get<KannalaBrandt>(random_model(2, stream, i)), i);
    check_nested(std::get<Eucm>(random_model(4, stream, i)), i);
    check_nested(std::get<DoubleSphere>(random_model(5, stream, i)), i);
  }
}

TEST_CASE("numbers that are not finite prove nothing") {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e308}) {
    const Interval slopes = radial_slopes(KannalaBrandt{.k2 = bad}, 0, 3);
    CHECK_FALSE(slopes.low > -1);
    CHECK(largest_growing_angle(KannalaBrandt{.k1 = 1, .k2 = -std::abs(bad)}) < 1e-6);
  }
}
