#include <catch2/catch.hpp>
#include <numeric>

#include "sampler/splits.h"

using namespace cps;

TEST_CASE("parts get their share as nearly as whole things allow, and at least one each") {
  for (int count = 3; count < 200; ++count) {
    const std::vector<double> weights(count, 1.0);
    const std::vector<Part> parts = deal_parts(weights, 0.7, 0.15, make_stream(count, "t"));
    int counts[3] = {0, 0, 0};
    for (Part part : parts) ++counts[static_cast<int>(part)];
    CHECK(counts[0] >= 1);
    CHECK(counts[1] >= 1);
    CHECK(counts[2] >= 1);
    if (count >= 7) {
      CHECK(std::abs(counts[0] - 0.7 * count) <= 1.0);
      CHECK(std::abs(counts[1] - 0.15 * count) <= 1.0);
    }
  }
}

TEST_CASE("unequal weights are balanced too") {
  std::vector<double> weights;
  for (int i = 0; i < 60; ++i) weights.push_back(10 + 190 * random_uniform(make_stream(0, "w"), i));
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const std::vector<Part> parts = deal_parts(weights, 0.7, 0.15, make_stream(5, "t"));
  double sums[3] = {0, 0, 0};
  for (std::size_t i = 0; i < weights.size(); ++i) sums[static_cast<int>(parts[i])] += weights[i];
  CHECK(sums[0] / total == Approx(0.70).margin(0.03));
  CHECK(sums[1] / total == Approx(0.15).margin(0.03));
}

TEST_CASE("who goes where is drawn: each of ten things is in test about as often") {
  int in_test[10] = {};
  const std::vector<double> weights(10, 1.0);
  for (int seed = 0; seed < 4000; ++seed) {
    const std::vector<Part> parts = deal_parts(weights, 0.7, 0.15, make_stream(seed, "t"));
    for (int i = 0; i < 10; ++i) in_test[i] += parts[i] == Part::test;
  }
  const double mean = std::accumulate(in_test, in_test + 10, 0.0) / 10;
  double chi2 = 0;
  for (int n : in_test) chi2 += (n - mean) * (n - mean) / (mean * (1 - mean / 4000));
  CHECK(chi2 < 27.9);  // χ²(9), p = 0.001
}
