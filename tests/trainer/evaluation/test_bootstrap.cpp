#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "trainer/evaluation/bootstrap.h"

using namespace cps;

namespace {

Interval interval_of_mean(const std::vector<double>& values, const std::vector<int>& clusters,
                          std::uint64_t seed) {
  const auto mean = [&](std::span<const int> images) {
    double sum = 0;
    for (int i : images) sum += values[i];
    return std::vector{sum / static_cast<double>(images.size())};
  };
  return bootstrap_intervals(clusters, mean, 400, make_stream(seed, "bootstrap"))[0];
}

}  // namespace

TEST_CASE("the 95 % interval of a mean covers the true mean at its nominal rate") {
  // 300 samples of 60 normal numbers: 95 % intervals cover the true mean, 0, in 94 % of samples of this size
  // (the percentile interval is a little narrow); four standard deviations of the count about that.
  const int samples = 300, n = 60;
  int covered = 0;
  std::vector<int> each(n);
  for (int i = 0; i < n; ++i) each[i] = i;
  for (int s = 0; s < samples; ++s) {
    std::vector<double> values;
    for (int i = 0; i < n; ++i) values.push_back(random_normal(make_stream(s, "sample"), i));
    const Interval interval = interval_of_mean(values, each, s);
    covered += interval.low <= 0 && interval.high >= 0;
  }
  CHECK(covered > samples * .94 - 4 * std::sqrt(samples * .94 * .06));
  CHECK(covered < samples * .94 + 4 * std::sqrt(samples * .94 * .06));
}

TEST_CASE("images of one cluster count once") {
  // Twenty numbers, and the same twenty ten times over, ten images to a cluster: the same interval.
  std::vector<double> once, often;
  std::vector<int> single, clusters;
  for (int i = 0; i < 20; ++i) {
    once.push_back(random_normal(make_stream(3, "sample"), i));
    single.push_back(i);
    for (int k = 0; k < 10; ++k) {
      often.push_back(once.back());
      clusters.push_back(i);
    }
  }
  const Interval a = interval_of_mean(once, single, 1), b = interval_of_mean(often, clusters, 1);
  CHECK(a.low == Approx(b.low));
  CHECK(a.high == Approx(b.high));
  CHECK(interval_of_mean(once, single, 1) == a);
  CHECK_FALSE(interval_of_mean(once, single, 2) == a);
  CHECK(std::isinf(interval_of_mean(once, std::vector<int>(20, 7), 1).high));
}
