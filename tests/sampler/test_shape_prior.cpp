#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sampler/shape_prior.h"

using namespace cps;

namespace {

constexpr int count = 20000;

/// Kolmogorov's distance between a sample and a distribution, times √n; above 1.95 with probability .001
/// (Kolmogorov 1933).
template <typename Cdf>
double kolmogorov(std::vector<double> sample, Cdf cdf) {
  std::sort(sample.begin(), sample.end());
  const double n = static_cast<double>(sample.size());
  double distance = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double p = cdf(sample[i]), rank = static_cast<double>(i);
    distance = std::max({distance, p - rank / n, (rank + 1) / n - p});
  }
  return distance * std::sqrt(n);
}
constexpr double one_in_a_thousand = 1.95;

double normal_cdf(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

double uniform_cdf(double x, double low, double high) {
  return std::clamp((x - low) / (high - low), 0.0, 1.0);
}

Stream draw(int i) {
  return substream(make_stream(9, "shape"), i);
}

}  // namespace

TEST_CASE("shapes have the distribution that is documented") {
  std::vector<double> corner, b, c;
  for (int i = 0; i < count; ++i) {
    const LensShape shape = draw_shape(draw(i));
    corner.push_back(shape.corner);
    b.push_back((shape.b + 0.35) / 0.35);
    c.push_back((shape.c + 0.1 * shape.b) / 0.15);
  }
  CHECK(kolmogorov(corner, [](double x) { return uniform_cdf(x, -0.33, 0.20); }) < one_in_a_thousand);
  CHECK(kolmogorov(b, normal_cdf) < one_in_a_thousand);
  CHECK(kolmogorov(c, normal_cdf) < one_in_a_thousand);
  double b_and_c = 0, corner_and_b = 0;
  for (int i = 0; i < count; ++i) {
    b_and_c += b[i] * c[i];
    corner_and_b += (corner[i] + 0.065) / (0.53 / std::sqrt(12)) * b[i];
  }
  CHECK(std::abs(b_and_c) < 3.3 * std::sqrt(count));
  CHECK(std::abs(corner_and_b) < 3.3 * std::sqrt(count));
}

TEST_CASE("the corner of a radial lens moves as its shape says, and shapes without a lens are counted") {
  int none = 0;
  for (int i = 0; i < count; ++i) {
    const LensShape shape = draw_shape(draw(i));
    const auto lens = radial_lens(shape);
    none += !lens;
    if (!lens) continue;
    const Eigen::Vector2d corner(0.8, 0.6);
    REQUIRE(distort(*lens, corner).norm() - 1 == Approx(shape.corner).margin(1e-12));
    REQUIRE(lens->k2 == Approx(shape.b * lens->k1));
    REQUIRE(lens->k3 == Approx(shape.c * lens->k1));
  }
  // 1 + b + c = 1 + .9 b + .15 n is normal.
  const double mean = 1 - 0.9 * 0.35, sd = std::hypot(0.9 * 0.35, 0.15);
  const double p = normal_cdf((0.25 - mean) / sd) - normal_cdf((-0.25 - mean) / sd);
  CHECK(std::abs(none - p * count) < 3.3 * std::sqrt(count * p * (1 - p)));
}

TEST_CASE("tangential terms have a uniform length and a uniform direction") {
  std::vector<double> length, angle;
  for (int i = 0; i < count; ++i)
    if (const auto lens = draw_from_shape_prior(0.015, draw(i))) {
      length.push_back(std::hypot(lens->p1, lens->p2));
      angle.push_back(std::atan2(lens->p1, lens->p2));
    }
  CHECK(kolmogorov(length, [](double x) { return uniform_cdf(x, 0, 0.015); }) < one_in_a_thousand);
  CHECK(kolmogorov(angle, [](double x) { return uniform_cdf(x, -M_PI, M_PI); }) < one_in_a_thousand);
}
