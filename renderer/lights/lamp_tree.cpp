#include "renderer/lights/lamp_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/math/fast_math.h"

namespace cps {
namespace {

float sine_of(float cosine) {
  return std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
}

/// Cosine of a + b, of the half turn where that is more.
float cos_of_sum(float cos_a, float cos_b) {
  if (cos_a + cos_b <= 0.0f) return -1.0f;
  return cos_a * cos_b - sine_of(cos_a) * sine_of(cos_b);
}

/// Cosine of a − b, of 0 where that is less.
float cos_of_difference(float cos_a, float cos_b) {
  if (cos_a >= cos_b) return 1.0f;
  return cos_a * cos_b + sine_of(cos_a) * sine_of(cos_b);
}

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

/// Mean of 1/distance² to lamps spread evenly over a disc of this squared radius in whose plane the point
/// lies, its logarithm held back near the rim and inside, where single lamps are closest: streets are that
/// flat. Taking the distance to the middle instead (Conty & Kulla) sends half of all choices far away from
/// the lamps around the point.
float mean_inverse_square(float distance2, float radius2) {
  constexpr float most = 6.0f;
  const float smallest2 = std::max(radius2, 1e-12f);
  if (distance2 > 1e4f * smallest2) return 1.0f / distance2;
  constexpr float ln_2 = 0.69314718f;
  const float logarithm = distance2 > smallest2 ? ln_2 * log2_of(distance2 / (distance2 - smallest2)) : most;
  return std::min(logarithm, most) / smallest2;
}

/// Upper bound, but for a factor, of the light that the lamps send to a surface at `point` (Conty & Kulla,
/// equation 3). The box is taken for its sphere.
float importance(const LampBounds& lamps, const Vec3& point, const Vec3& normal) {
  const Vec3 to_point = point - lamps.box.center();
  const float radius2 = 0.25f * lamps.box.diagonal().squaredNorm();
  const float distance2 = to_point.squaredNorm();
  const bool outside = distance2 > radius2;
  // Angle under which the sphere is seen.
  const float cos_seen = outside ? std::sqrt(1.0f - radius2 / distance2) : -1.0f;
  const Vec3 direction = to_point / std::sqrt(std::max(distance2, 1e-20f));

  const float along_axis = lamps.axis.dot(direction);
  const float cos_axis = lamps.two_sided ? std::abs(along_axis) : along_axis;
  const float cos_beyond = cos_of_difference(cos_of_difference(cos_axis, lamps.cos_cone), cos_seen);
  if (cos_beyond < lamps.cos_falloff) return 0.0f;
  const float cos_incidence = outside ? cos_of_difference(-normal.dot(direction), cos_seen) : 1.0f;
  if (cos_incidence <= 0.0f) return 0.0f;
  return lamps.intensity * cos_beyond * cos_incidence * mean_inverse_square(distance2, radius2);
}

/// Cost of a group: its light times its extent in space and in direction.
float cost(const LampBounds& lamps, float longest_side, float side) {
  if (lamps.intensity == 0.0f) return 0.0f;
  const Vec3 d = lamps.box.diagonal();
  const float surface = d.x() * d.y() + d.y() * d.z() + d.z() * d.x() + 1e-4f * d.squaredNorm();
  const float directions = 1.0f - cos_of_sum(lamps.cos_cone, lamps.cos_falloff);
  return lamps.intensity * directions * surface * (longest_side / side);  // rather across long boxes
}

constexpr int bins = 12;
constexpr int deepest_by_cost = 32;  // below that halves, so that a way has less than 64 steps

struct Split {
  int axis = -1;
  float below = 0;  ///< centres
};

class Builder {
 public:
  Builder(const std::vector<LampBounds>& lamps, LampTree& tree) : lamps(lamps), tree(tree) {}

  /// Appends the tree of these lamps.
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
    if (depth < deepest_by_cost) {
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
    float least = std::numeric_limits<float>::infinity();
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
        if (joined.intensity > 0.0f && above[i] > 0.0f && both < least) {
          least = both;
          best = {axis, low + side * static_cast<float>(i) / bins};
        }
      }
    }
    return best;
  }

  const std::vector<LampBounds>& lamps;
  LampTree& tree;
};

/// Of choosing the first of two children.
float first_share(const LampTree& tree, std::size_t node, const Vec3& point, const Vec3& normal) {
  const float first = importance(tree.nodes[node + 1].bounds, point, normal);
  const float second = importance(tree.nodes[tree.nodes[node].second_child].bounds, point, normal);
  return first + second > 0.0f ? first / (first + second) : -1.0f;
}

}  // namespace

LampTree::Choice LampTree::choose(const Vec3& point, const Vec3& normal, float u) const {
  float probability = 1.0f;
  std::size_t node = 0;
  while (!nodes[node].is_leaf) {
    const float first = first_share(*this, node, point, normal);
    if (first < 0.0f) return {0, 0.0f};
    constexpr float below_1 = 0x1.fffffep-1f;
    if (u < first) {
      u = std::min(u / first, below_1);
      probability *= first;
      ++node;
    } else {
      u = std::min((u - first) / (1.0f - first), below_1);
      probability *= 1.0f - first;
      node = nodes[node].second_child;
    }
  }
  return {nodes[node].second_child, probability};
}

float LampTree::probability(const Vec3& point, const Vec3& normal, std::uint32_t lamp) const {
  if (way_lengths[lamp] == no_way) return 0.0f;
  float probability = 1.0f;
  std::size_t node = 0;
  for (int step = 0; step < way_lengths[lamp]; ++step) {
    const float first = first_share(*this, node, point, normal);
    if (first < 0.0f) return 0.0f;
    const bool second = ways[lamp] >> step & 1;
    probability *= second ? 1.0f - first : first;
    node = second ? nodes[node].second_child : node + 1;
  }
  return probability;
}

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
