#include <algorithm>
#include <array>
#include <limits>

#include "renderer/lights/lamp_tree.h"
#include "renderer/math/cosines.h"

namespace cps {
namespace {

/// Bounds of both groups.
LampBounds join(const LampBounds& a, const LampBounds& b) {
  if (a.intensity == 0.0f) return b;
  if (b.intensity == 0.0f) return a;
  LampBounds both;
  both.box = a.box.merged(b.box);
  both.intensity = a.intensity + b.intensity;
  both.two_sided = a.two_sided || b.two_sided;
  both.cos_falloff = std::min(a.cos_falloff, b.cos_falloff);
  const Vec3 b_axis = both.two_sided && a.axis.dot(b.axis) < 0.0f ? Vec3(-b.axis) : b.axis;
  const Vec3 middle = a.axis + b_axis;
  const float length = middle.norm();
  if (length < 1e-3f) {
    both.axis = a.axis;
    both.cos_cone = -1.0f;
    return both;
  }
  both.axis = middle / length;
  both.cos_cone =
      std::min(cos_of_sum(both.axis.dot(a.axis), a.cos_cone), cos_of_sum(both.axis.dot(b_axis), b.cos_cone));
  return both;
}

/// Cost of a group in the tree: its light times its extent in space and in direction.
float cost(const LampBounds& lamps, float longest_side, float side) {
  if (lamps.intensity == 0.0f) return 0.0f;
  const Vec3 d = lamps.box.diagonal();
  const float surface = d.x() * d.y() + d.y() * d.z() + d.z() * d.x() + 1e-4f * d.squaredNorm();
  const float directions = 1.0f - cos_of_sum(lamps.cos_cone, lamps.cos_falloff);
  return lamps.intensity * directions * surface *
         (longest_side / side);  // prefers to split long boxes across
}

constexpr int bins = 12;
constexpr int max_depth_by_cost = 32;  // deeper groups are halved, so that a way has less than 64 steps

struct Split {
  int axis = -1;
  float below = 0;  ///< centres below this coordinate go to the first child
};

class Builder {
 public:
  Builder(const std::vector<LampBounds>& lamps, LampTree& tree) : lamps(lamps), tree(tree) {}

  /// Appends the subtree of these lamps.
  void add(std::uint32_t* begin, std::uint32_t* end, std::uint64_t way, int depth) {
    LampBounds bounds;
    for (const std::uint32_t* i = begin; i != end; ++i) bounds = join(bounds, lamps[*i]);
    const std::size_t node = tree.nodes.size();
    tree.nodes.push_back({bounds, *begin, end - begin == 1});
    if (end - begin == 1) {
      tree.ways[*begin] = way;
      tree.way_lengths[*begin] = static_cast<std::uint8_t>(depth);
      return;
    }
    std::uint32_t* middle = divide(begin, end, bounds, depth);
    add(begin, middle, way, depth + 1);
    tree.nodes[node].second_child = static_cast<std::uint32_t>(tree.nodes.size());
    add(middle, end, way | std::uint64_t{1} << depth, depth + 1);
  }

 private:
  float center(std::uint32_t lamp, int axis) const { return lamps[lamp].box.center()[axis]; }

  std::uint32_t* divide(std::uint32_t* begin, std::uint32_t* end, const LampBounds& bounds, int depth) const {
    if (depth < max_depth_by_cost) {
      const Split split = best_split(begin, end, bounds);
      if (split.axis >= 0) {
        std::uint32_t* middle = std::stable_partition(
            begin, end, [&](std::uint32_t i) { return center(i, split.axis) < split.below; });
        if (middle != begin && middle != end) return middle;
      }
    }
    return begin + (end - begin) / 2;
  }

  Split best_split(const std::uint32_t* begin, const std::uint32_t* end, const LampBounds& bounds) const {
    const Vec3 sides = bounds.box.diagonal();
    Split best;
    float min_cost = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const float low = bounds.box.min()[axis], side = sides[axis];
      if (!(side > 0.0f)) continue;
      std::array<LampBounds, bins> bin;
      for (const std::uint32_t* i = begin; i != end; ++i) {
        const int index = std::clamp(static_cast<int>((center(*i, axis) - low) / side * bins), 0, bins - 1);
        bin[index] = join(bin[index], lamps[*i]);
      }
      std::array<float, bins> above{};  // cost of the bins from here on
      LampBounds joined;
      for (int i = bins - 1; i > 0; --i) {
        joined = join(joined, bin[i]);
        above[i] = cost(joined, sides.maxCoeff(), side);
      }
      joined = {};
      for (int i = 1; i < bins; ++i) {
        joined = join(joined, bin[i - 1]);
        const float both = cost(joined, sides.maxCoeff(), side) + above[i];
        if (joined.intensity > 0.0f && above[i] > 0.0f && both < min_cost) {
          min_cost = both;
          best = {axis, low + side * static_cast<float>(i) / bins};
        }
      }
    }
    return best;
  }

  const std::vector<LampBounds>& lamps;
  LampTree& tree;
};

}  // namespace

LampTree make_lamp_tree(const std::vector<LampBounds>& lamps) {
  LampTree tree;
  tree.ways.assign(lamps.size(), 0);
  tree.way_lengths.assign(lamps.size(), LampTree::no_way);
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < lamps.size(); ++i) {
    if (lamps[i].intensity > 0.0f) order.push_back(i);
  }
  if (order.empty()) return tree;
  tree.nodes.reserve(2 * order.size() - 1);
  Builder(lamps, tree).add(order.data(), order.data() + order.size(), 0, 0);
  return tree;
}

}  // namespace cps
