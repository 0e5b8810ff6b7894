#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "scenes/scene.h"

namespace cps {

/// Ray queries against a scene's geometry, built once and safe to use from any thread. Alpha-masked surfaces
/// count as solid. Shells turned inside out are left out, because a camera sees through them.
struct SceneRays {
  /// Throws std::runtime_error if Embree cannot build the acceleration structure.
  explicit SceneRays(const Scene& scene);
  ~SceneRays();
  SceneRays(SceneRays&&) noexcept;

  struct Geometry;
  std::unique_ptr<Geometry> geometry;
};

/// The first surface that a ray meets.
struct SurfaceHit {
  double distance_m = 0;
  Eigen::Vector3f normal;                ///< of the triangle's front face: world, unit
  bool shows_back = false;               ///< the ray meets the back of a single-sided surface
  int instance = 0;                      ///< index into Scene::instances
  int triangle = 0;                      ///< index into Mesh::triangles
  Eigen::Vector2f barycentric = {0, 0};  ///< weights of the triangle's second and third vertex
};

/// The first surface from `from` (world) along `direction` (world, unit), if any.
std::optional<SurfaceHit> first_hit(const SceneRays& rays, const Eigen::Vector3f& from,
                                    const Eigen::Vector3f& direction);

}  // namespace cps
