#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "scenes/scene.h"

namespace cps {

/// Ray queries against a scene's geometry (masked leaves count as solid, shells turned inside out are not
/// there, as whoever looks at them sees through them), built once and asked from any thread.
struct SceneRays {
  /// Throws std::runtime_error when the tree cannot be built.
  explicit SceneRays(const Scene& scene);
  ~SceneRays();
  SceneRays(SceneRays&&) noexcept;

  struct Geometry;
  std::unique_ptr<Geometry> geometry;
};

/// What a ray meets first.
struct SurfaceHit {
  double distance_m = 0;
  Eigen::Vector3f normal;   ///< of the triangle's front, world, unit
  bool shows_back = false;  ///< the back of a single-sided surface
};

/// The first surface from `from` (world) into `direction` (unit), if any.
std::optional<SurfaceHit> first_hit(const SceneRays& rays, const Eigen::Vector3f& from,
                                    const Eigen::Vector3f& direction);

}  // namespace cps
