#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "random/counter_hash.h"
#include "trainer/evaluation/coverage.h"

using namespace cps;

TEST_CASE("shares within the stated deviations are counts of known errors") {
  // Errors of .1, .6, 1.2 and 2.6 deviations, of both signs, with another deviation for each output and
  // image.
  const std::vector<double> ratios{.1, -.6, 1.2, -2.6};
  std::vector<Outputs> errors(ratios.size()), deviations(ratios.size());
  for (std::size_t i = 0; i < ratios.size(); ++i)
    for (int k = 0; k < output_count; ++k) {
      deviations[i][k] = (k + 1) * std::pow(10, static_cast<double>(i) - 2);
      errors[i][k] = ratios[i] * deviations[i][k];
    }
  const Coverage coverage = coverage_of(errors, deviations);
  for (int k = 0; k < output_count; ++k) {
    CHECK(coverage.within_one[k] == .5);
    CHECK(coverage.within_two[k] == .75);
    CHECK(coverage.scaled_error[k] == Approx(std::sqrt((.01 + .36 + 1.44 + 6.76) / 4)));
    for (int point = 0; point < reliability_points; ++point) {
      const double z = reliability_deviations(point);
      const double expected = z < .6 ? .25 : z < 1.2 ? .5 : z < 2.6 ? .75 : 1;
      CHECK(coverage.within[point][k] == expected);
    }
  }
  CHECK(reliability_deviations(0) == .25);
  CHECK(reliability_deviations(reliability_points - 1) == 3);
}

TEST_CASE("normal errors have the shares of a normal distribution where deviations are right") {
  CHECK(normal_share(1) == Approx(.682689).epsilon(1e-5));
  CHECK(normal_share(2) == Approx(.954500).epsilon(1e-5));
  constexpr int images = 4000;
  std::vector<Outputs> errors(images), deviations(images), half(images);
  for (int i = 0; i < images; ++i)
    for (int k = 0; k < output_count; ++k) {
      deviations[i][k] = .01 * (k + 1);
      half[i][k] = deviations[i][k] / 2;
      errors[i][k] = deviations[i][k] * random_normal(make_stream(i, "error"), k);
    }
  const Coverage right = coverage_of(errors, deviations), too_small = coverage_of(errors, half);
  for (int point = 0; point < reliability_points; ++point)
    for (int k = 0; k < output_count; ++k) {
      // Five standard deviations of a count: one of the 192 is beyond them in less than one run of a
      // thousand.
      const auto check_near = [&](double share, double expected) {
        CHECK(std::abs(share - expected) <= 5 * std::sqrt(expected * (1 - expected) / images) + 1e-9);
      };
      check_near(right.within[point][k], normal_share(reliability_deviations(point)));
      check_near(too_small.within[point][k], normal_share(reliability_deviations(point) / 2));
    }
}
