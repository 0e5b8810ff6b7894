#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "renderer/math/color.h"

namespace cps {

/// Where a group of lamps is, and where it shines: all its directions of full strength lie within a cone
/// around `axis`, and its light ends at an angle beyond that cone.
struct LampBounds {
  Eigen::AlignedBox3f box;
  Vec3 axis = Vec3::UnitZ();
  float cos_cone = 1;     ///< of the cone's half angle: 1 for one direction, −1 for all
  float cos_falloff = 0;  ///< of the angle beyond it, 0 for surfaces
  float intensity = 0;    ///< along the axis, kcd
  bool two_sided = false;
};

/// Many lamps as a binary tree of bounds, so that one is chosen by how much light it may send to a point, at
/// logarithmic cost (Conty Estévez & Kulla 2018, "Importance sampling of many lights with adaptive tree
/// splitting"; without the splitting).
struct LampTree {
  struct Node {
    LampBounds bounds;
    std::uint32_t second_child;  ///< the first one follows its parent; in a leaf the lamp
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
  /// A lamp for a point with a surface facing `normal`, by a uniform number.
  Choice choose(const Vec3& point, const Vec3& normal, float u) const;

  /// The probability with which that chooses `lamp`.
  float probability(const Vec3& point, const Vec3& normal, std::uint32_t lamp) const;
};

/// Lamps of no intensity are never chosen.
LampTree make_lamp_tree(const std::vector<LampBounds>& lamps);

}  // namespace cps
