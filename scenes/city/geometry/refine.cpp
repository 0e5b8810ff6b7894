#include "scenes/city/geometry/refine.h"

#include <map>

namespace cps::city {
namespace {

float squared_length(const Surface& s, std::uint32_t a, std::uint32_t b) {
  const float dx = s.positions[a].x() - s.positions[b].x(), dz = s.positions[a].z() - s.positions[b].z();
  return dx * dx + dz * dz;
}

std::uint32_t add_middle(Surface& s, std::uint32_t a, std::uint32_t b) {
  s.positions.push_back((s.positions[a] + s.positions[b]) / 2);
  s.normals.push_back((s.normals[a] + s.normals[b]).normalized());
  s.uvs.push_back((s.uvs[a] + s.uvs[b]) / 2);
  if (!s.colors.empty()) {
    std::array<std::uint8_t, 4> mean;
    for (int c = 0; c < 4; ++c) mean[c] = static_cast<std::uint8_t>((s.colors[a][c] + s.colors[b][c]) / 2);
    s.colors.push_back(mean);
  }
  return static_cast<std::uint32_t>(s.positions.size()) - 1;
}

}  // namespace

void refine(Surface& surface, double max_edge_m) {
  const auto limit = static_cast<float>(max_edge_m * max_edge_m);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, 0);
    if (is_new) entry->second = add_middle(surface, a, b);
    return entry->second;
  };
  std::vector<std::uint32_t> pending;
  pending.swap(surface.indices);
  while (!pending.empty()) {
    const std::uint32_t c = pending.back(), b = *(pending.end() - 2), a = *(pending.end() - 3);
    pending.resize(pending.size() - 3);
    const float ab = squared_length(surface, a, b), bc = squared_length(surface, b, c),
                ca = squared_length(surface, c, a);
    if (std::max({ab, bc, ca}) <= limit) {
      surface.indices.insert(surface.indices.end(), {a, b, c});
    } else if (ab >= bc && ab >= ca) {
      const std::uint32_t m = middle(a, b);
      pending.insert(pending.end(), {a, m, c, m, b, c});
    } else if (bc >= ca) {
      const std::uint32_t m = middle(b, c);
      pending.insert(pending.end(), {a, b, m, a, m, c});
    } else {
      const std::uint32_t m = middle(c, a);
      pending.insert(pending.end(), {a, b, m, m, b, c});
    }
  }
}

void shade(Surface& surface, const std::function<double(const Vec2&)>& light) {
  surface.colors.resize(surface.positions.size());
  for (std::size_t i = 0; i < surface.positions.size(); ++i)
    surface.colors[i] = gray_color(light({surface.positions[i].x(), -surface.positions[i].z()}));
}

}  // namespace cps::city
