#include "sampler/splits.h"

#include <numeric>

#include "random/shuffle.h"

namespace cps {

std::vector<Part> deal_parts(std::span<const double> weights, double train_share, double val_share,
                             Stream stream) {
  const std::vector<std::size_t> order = shuffled_order(weights.size(), stream);
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double targets[3] = {train_share * total, val_share * total, (1 - train_share - val_share) * total};
  double dealt[3] = {0, 0, 0};
  std::vector<Part> parts(weights.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const std::size_t item = order[rank];
    // The first three items go to one part each, so that none stays empty; each further one goes to the part
    // that is furthest below its target.
    int part = static_cast<int>(rank);
    if (rank >= 3) {
      part = 0;
      for (int other : {1, 2})
        if (targets[other] - dealt[other] > targets[part] - dealt[part]) part = other;
    }
    dealt[part] += weights[item];
    parts[item] = static_cast<Part>(part);
  }
  return parts;
}

}  // namespace cps
