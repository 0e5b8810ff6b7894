#include "trainer/evaluation/bootstrap.h"

#include <cmath>
#include <map>
#include <vector>

#include "numbers/quantile.h"

namespace cps {

std::vector<Interval> bootstrap_intervals(
    std::span<const int> clusters, const std::function<std::vector<double>(std::span<const int>)>& statistics,
    int resamples, Stream stream) {
  std::map<int, std::vector<int>> by_cluster;
  std::vector<int> images(clusters.size());
  for (int i = 0; i < static_cast<int>(clusters.size()); ++i) {
    by_cluster[clusters[i]].push_back(i);
    images[i] = i;
  }
  std::vector<const std::vector<int>*> members;
  for (const auto& [cluster, its_images] : by_cluster) members.push_back(&its_images);
  const std::size_t count = statistics(images).size();
  if (members.size() < 2 || resamples < 2) return std::vector<Interval>(count, {-INFINITY, INFINITY});

  std::vector<std::vector<double>> values(count);
  for (int r = 0; r < resamples; ++r) {
    const Stream draw = substream(stream, r);
    images.clear();
    for (std::size_t c = 0; c < members.size(); ++c) {
      const auto& drawn = *members[random_below(draw, c, members.size())];
      images.insert(images.end(), drawn.begin(), drawn.end());
    }
    const std::vector<double> drawn = statistics(images);
    for (std::size_t k = 0; k < count; ++k) values[k].push_back(drawn[k]);
  }
  std::vector<Interval> intervals;
  for (const auto& of_one : values) intervals.push_back({quantile(of_one, .025), quantile(of_one, .975)});
  return intervals;
}

}  // namespace cps
