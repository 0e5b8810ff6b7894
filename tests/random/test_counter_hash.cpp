#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "random/counter_hash.h"

using namespace cps;

namespace {

/// Largest distance between the empirical distribution of `values` and `cdf` (Kolmogorov–Smirnov).
template <typename Cdf>
double kolmogorov_smirnov(std::vector<double> values, Cdf cdf) {
  std::sort(values.begin(), values.end());
  double worst = 0;
  const double n = static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double f = cdf(values[i]);
    worst = std::max({worst, std::abs(f - i / n), std::abs((i + 1) / n - f)});
  }
  return worst;
}

constexpr int draws = 200'000;
// P(D·√n > 1.95) ≈ 0.001.
const double critical = 1.95 / std::sqrt(static_cast<double>(draws));

}  // namespace

TEST_CASE("uniform numbers are uniform along a stream and across streams") {
  std::vector<double> along(draws), across(draws), seeds(draws);
  for (int i = 0; i < draws; ++i) {
    along[i] = random_uniform(make_stream(0, "lens"), i);
    across[i] = random_uniform(substream(make_stream(0, "lens"), i), 0);
    seeds[i] = random_uniform(make_stream(i, "lens"), 0);
  }
  const auto cdf = [](double x) { return x; };
  CHECK(kolmogorov_smirnov(along, cdf) < critical);
  CHECK(kolmogorov_smirnov(across, cdf) < critical);
  CHECK(kolmogorov_smirnov(seeds, cdf) < critical);
}

TEST_CASE("normal numbers are normal") {
  std::vector<double> values(draws);
  for (int i = 0; i < draws; ++i) values[i] = random_normal(make_stream(7, "noise"), i);
  CHECK(kolmogorov_smirnov(values, [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }) < critical);
}

TEST_CASE("streams do not repeat each other") {
  std::vector<std::uint64_t> bits;
  for (int s = 0; s < 300; ++s)
    for (int i = 0; i < 300; ++i) {
      bits.push_back(random_bits(substream(make_stream(0, "a"), s), i));
      bits.push_back(random_bits(make_stream(s, "b"), i));
    }
  std::sort(bits.begin(), bits.end());
  CHECK(std::adjacent_find(bits.begin(), bits.end()) == bits.end());
}

TEST_CASE("integers below a bound cover it evenly") {
  std::vector<int> counts(7, 0);
  for (int i = 0; i < 70'000; ++i) ++counts.at(random_below(make_stream(3, "die"), i, 7));
  double chi2 = 0;
  for (int c : counts) chi2 += (c - 10'000.0) * (c - 10'000.0) / 10'000.0;
  CHECK(chi2 < 22.46);  // χ²(6), p = 0.001
}

// Datasets made earlier must come out again: these values may only change together with the dataset's schema.
TEST_CASE("the drawn numbers never change") {
  CHECK(random_bits(make_stream(0, "lens"), 0) == 0x8b8c39cbf9b5a0d7ull);
  CHECK(random_bits(make_stream(1, "lens"), 7) == 0x4a802b64a6c95ed2ull);
  CHECK(random_bits(substream(make_stream(42, ""), 3), 1) == 0x493f4cd4f5daf063ull);
}
