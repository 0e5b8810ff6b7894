#pragma once

#include <cstdint>
#include <vector>

#include "renderer/lights/lamp_bounds.h"

namespace cps {

/// Many lamps as a binary tree of bounds. It chooses one by how much light it may send to a point, at
/// logarithmic cost (Conty Estévez & Kulla 2018, "Importance sampling of many lights with adaptive tree
/// splitting"; without the splitting).
struct LampTree {
  struct Node {
    LampBounds bounds;
    std::uint32_t second_child;  ///< the first one follows its parent. In a leaf: the lamp
    bool is_leaf;
  };
  std::vector<Node> nodes;  ///< the root first
  std::vector<std::uint64_t>
      ways;  ///< to every lamp from the root: bit i set where step i takes the second child
  std::vector<std::uint8_t> way_lengths;  ///< steps from the root; no_way for lamps that send no light

  static constexpr std::uint8_t no_way = 255;

  bool empty() const { return nodes.empty(); }

  struct Choice {
    std::uint32_t lamp;
    float probability;  ///< 0: no lamp reaches this point
  };
  /// Chooses a lamp for a surface at `point` facing `normal`; `u` is uniform in [0, 1).
  Choice choose(const Vec3& point, const Vec3& normal, float u) const;

  /// Probability with which choose() chooses `lamp`.
  float probability(const Vec3& point, const Vec3& normal, std::uint32_t lamp) const;
};

/// Lamps of no intensity are never chosen.
LampTree make_lamp_tree(const std::vector<LampBounds>& lamps);

}  // namespace cps
