#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "trainer/images/batches.h"

using namespace cps;

namespace {

/// 100 images of one size, 37 of another and 5 of a third, mixed.
std::vector<ImageSize> three_sizes() {
  std::vector<ImageSize> sizes;
  for (int i = 0; i < 142; ++i)
    sizes.push_back(i % 29 == 7  ? ImageSize{1920, 1080}
                    : i % 4 == 1 ? ImageSize{1392, 512}
                                 : ImageSize{480, 270});
  return sizes;
}

}  // namespace

TEST_CASE("batches never mix sizes and hold every image once per epoch") {
  const std::vector<ImageSize> sizes = three_sizes();
  for (int epoch = 1; epoch <= 5; ++epoch) {
    std::multiset<int> seen;
    for (const Batch& batch : shuffled_batches(sizes, 16, 3, epoch)) {
      REQUIRE(!batch.empty());
      CHECK(batch.size() <= 16);
      for (int i : batch) CHECK(sizes[i] == sizes[batch[0]]);
      seen.insert(batch.begin(), batch.end());
    }
    CHECK(seen.size() == sizes.size());
    CHECK(std::set<int>(seen.begin(), seen.end()).size() == sizes.size());
  }
}

TEST_CASE("batches of one size are of even length") {
  const std::vector<ImageSize> sizes(33, {480, 270});
  const auto batches = shuffled_batches(sizes, 16, 0, 1);
  REQUIRE(batches.size() == 3);
  for (const Batch& batch : batches) CHECK(batch.size() == 11);
}

TEST_CASE("sizes alternate in proportion to their counts") {
  const std::vector<ImageSize> sizes = three_sizes();
  const auto batches = shuffled_batches(sizes, 4, 9, 2);
  std::map<ImageSize, int> totals, so_far;
  for (const Batch& batch : batches) ++totals[sizes[batch[0]]];
  REQUIRE(totals.size() == 3);
  for (std::size_t b = 0; b < batches.size(); ++b) {
    ++so_far[sizes[batches[b][0]]];
    for (const auto& [size, total] : totals)
      CHECK(std::abs(so_far[size] - total * (b + 1.0) / batches.size()) <= 1.5);
  }
}

TEST_CASE("the order is a function of seed and epoch alone, and differs between them") {
  const std::vector<ImageSize> sizes = three_sizes();
  CHECK(shuffled_batches(sizes, 16, 5, 7) == shuffled_batches(sizes, 16, 5, 7));
  CHECK(shuffled_batches(sizes, 16, 5, 7) != shuffled_batches(sizes, 16, 5, 8));
  CHECK(shuffled_batches(sizes, 16, 5, 7) != shuffled_batches(sizes, 16, 6, 7));
}

TEST_CASE("every image is equally likely to come first, and to be mirrored") {
  const std::vector<ImageSize> sizes(10, {480, 270});
  const int epochs = 5000;
  std::vector<int> first(10), flipped(10);
  for (int epoch = 1; epoch <= epochs; ++epoch) {
    ++first[shuffled_batches(sizes, 10, 0, epoch)[0][0]];
    for (int i = 0; i < 10; ++i) flipped[i] += is_mirrored(0, epoch, i);
  }
  double chi2_first = 0, chi2_flipped = 0;
  for (int i = 0; i < 10; ++i) {
    chi2_first += (first[i] - epochs / 10.0) * (first[i] - epochs / 10.0) / (epochs / 10.0);
    chi2_flipped += (flipped[i] - epochs / 2.0) * (flipped[i] - epochs / 2.0) / (epochs / 4.0);
  }
  CHECK(chi2_first < 27.88);    // χ²(9), p = .001
  CHECK(chi2_flipped < 29.59);  // χ²(10), p = .001
}
