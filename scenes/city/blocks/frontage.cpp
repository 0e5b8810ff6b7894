#include "scenes/city/blocks/frontage.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/streets/junctions.h"

namespace cps::city {

Polygon without_repeats(const Polygon& polygon) {
  Polygon clean;
  for (const Vec2& p : polygon)
    if (clean.empty() || (p - clean.back()).norm() > 0.01) clean.push_back(p);
  while (clean.size() > 1 && (clean.front() - clean.back()).norm() < 0.01) clean.pop_back();
  return clean;
}

std::vector<Frontage> frontages(const StreetNetwork& network, const Block& block, const Outline& border) {
  // Rotated to start at a corner, so that no frontage wraps around the end of the list.
  struct Edge {
    Vec2 from, to;
    bool road;
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < border.points.size(); ++i) {
    const Vec2 &a = border.points[i], &b = border.points[(i + 1) % border.points.size()];
    const Side& side = block.sides[border.side[i]];
    // Nothing fronts on a roundabout's ring.
    const bool on_ring = border.corner[i] && network.junctions[network.end(side)].roundabout;
    if ((b - a).norm() > 0.01) edges.push_back({a, b, network.is_road(side) && !on_ring});
  }
  const auto turns = [&](std::size_t i) {  // at the end of edge i
    const Vec2 a = edges[i].to - edges[i].from,
               b = edges[(i + 1) % edges.size()].to - edges[(i + 1) % edges.size()].from;
    return std::abs(std::atan2(cross(a, b), a.dot(b))) > 2 * straight_on_rad ||
           edges[i].road != edges[(i + 1) % edges.size()].road;
  };
  std::size_t first = 0;
  while (first + 1 < edges.size() && !turns((first + edges.size() - 1) % edges.size())) ++first;
  std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(first), edges.end());
  std::vector<Frontage> result;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!edges[i].road) continue;
    if (result.empty() || (result.back().line.back() - edges[i].from).norm() > 0.01 ||
        turns((i + edges.size() - 1) % edges.size()))
      result.push_back({{edges[i].from}, false});
    result.back().line.push_back(edges[i].to);
    result.back().corner_at_end = edges[(i + 1) % edges.size()].road && turns(i);
  }
  return result;
}

}  // namespace cps::city
