#include "scenes/places/clearance.h"

#include <cmath>

#include "scenes/lattice.h"

namespace cps {
PlaceFault clearance_fault(const SceneRays& rays, const Eigen::Vector3d& position,
                           const Eigen::Vector3d& forward, double min_distance_m) {
  constexpr float cos_ahead = 0.7071f, cos_ground_slope = 0.7071f;  // 45°
  const Eigen::Vector3f from = position.cast<float>(), axis = forward.normalized().cast<float>();
  const auto& directions = sphere_directions<256>();
  std::size_t backs = 0, ahead = 0, hits_ahead = 0;
  bool is_blocked = false;
  for (const Eigen::Vector3f& direction : directions) {
    const bool is_ahead = direction.dot(axis) > cos_ahead;
    ahead += is_ahead;
    const auto hit = first_hit(rays, from, direction);
    if (!hit) continue;
    backs += hit->shows_back;
    hits_ahead += is_ahead;
    const bool is_ground = direction.y() < 0 && std::abs(hit->normal.y()) > cos_ground_slope;
    is_blocked |= is_ahead && !is_ground && hit->distance_m < min_distance_m;
  }
  if (backs * 3 >= directions.size()) return PlaceFault::inside;
  if (is_blocked) return PlaceFault::too_close;
  return hits_ahead * 4 < ahead ? PlaceFault::only_sky : PlaceFault::none;
}

}  // namespace cps
