#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sampler/lenses/shape_prior.h"
#include "sampler/lenses/tangential_draw.h"
#include "tests/sampler/lenses/kolmogorov.h"

using namespace cps;

namespace {

constexpr int count = 20000;

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
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d p = draw_tangential(0.015, draw(i));
    length.push_back(p.norm());
    angle.push_back(std::atan2(p[0], p[1]));
  }
  CHECK(kolmogorov(length, [](double x) { return uniform_cdf(x, 0, 0.015); }) < one_in_a_thousand);
  CHECK(kolmogorov(angle, [](double x) { return uniform_cdf(x, -M_PI, M_PI); }) < one_in_a_thousand);
}
