#pragma once

#include <Eigen/Core>
#include <memory>

#include "scenes/scene.h"

namespace cps {

/// Ray queries against a scene's geometry (masked leaves count as solid), built once and asked from any
/// thread.
struct ClearanceQuery {
  explicit ClearanceQuery(const Scene& scene);
  ~ClearanceQuery();
  ClearanceQuery(ClearanceQuery&&) noexcept;

  struct Geometry;
  std::unique_ptr<Geometry> geometry;
};

/// Whether a camera at `position` (world) may look along `forward` (any length but 0). It may not when a
/// third of all directions around it show the back of a single-sided surface (it is inside something or below
/// the ground), or when something nearer than `min_distance_m`, the ground apart, stands within 45° of
/// `forward`.
bool is_clear(const ClearanceQuery& query, const Eigen::Vector3d& position, const Eigen::Vector3d& forward,
              double min_distance_m);

}  // namespace cps
