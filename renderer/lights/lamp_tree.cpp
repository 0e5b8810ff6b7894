#include "renderer/lights/lamp_tree.h"

#include <algorithm>
#include <cmath>

#include "renderer/math/cosines.h"
#include "renderer/math/fast_math.h"

namespace cps {
namespace {

/// Mean of 1/distance² to lamps spread evenly over a disc of this squared radius in whose plane the point
/// lies (lamps of a street lie in a plane). Its logarithm is limited near the rim and inside, where single
/// lamps are closest. With the distance to the centre instead (Conty & Kulla), half of all choices go to
/// lamps far away from those around the point.
float mean_inverse_square(float distance2, float radius2) {
  constexpr float max_logarithm = 6.0f;
  const float limited_radius2 = std::max(radius2, 1e-12f);
  if (distance2 > 1e4f * limited_radius2) return 1.0f / distance2;
  constexpr float ln_2 = 0.69314718f;
  const float logarithm =
      distance2 > limited_radius2 ? ln_2 * log2_of(distance2 / (distance2 - limited_radius2)) : max_logarithm;
  return std::min(logarithm, max_logarithm) / limited_radius2;
}

/// Upper bound, up to a factor, of the light that the lamps send to a surface at `point` (Conty & Kulla,
/// equation 3). The box is replaced by its bounding sphere.
float importance(const LampBounds& lamps, const Vec3& point, const Vec3& normal) {
  const Vec3 to_point = point - lamps.box.center();
  const float radius2 = 0.25f * lamps.box.diagonal().squaredNorm();
  const float distance2 = to_point.squaredNorm();
  const bool outside = distance2 > radius2;
  // Half angle under which the sphere is seen.
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

/// Probability of choosing the first of two children; −1 if neither reaches the point.
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

}  // namespace cps
