#include "trainer/evaluation/trusted_edges.h"

#include <utility>

namespace cps {

std::vector<TrustedEdges> trusted_edges(const Predictor& predictor, std::span<const EvaluatedImage> images,
                                        std::span<const BatchImage> batch) {
  const std::vector<int> order = by_reprojection_error(images);
  std::vector<TrustedEdges> chosen;
  std::vector<BatchImage> members;
  const auto choose = [&](const char* rank, std::size_t place) {
    chosen.push_back({.rank = rank, .image = order[place]});
    members.push_back(batch[order[place]]);
  };
  choose("best", 0);
  if (order.size() > 2) choose("median", order.size() / 2);
  if (order.size() > 1) choose("worst", order.size() - 1);

  std::vector<FrameEvidence> evidence = predictor.evidence(members);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    chosen[i].evidence = std::move(evidence[i]);
    chosen[i].model = fit_lens(chosen[i].evidence).model;
  }
  return chosen;
}

}  // namespace cps
