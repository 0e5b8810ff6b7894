#pragma once

#include <limits>
#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/lights/lamp_tree.h"

namespace cps {

/// A point drawn on a lamp, and the light that it may send to a point in the scene.
struct LampSample {
  Vec3 direction;        ///< to the lamp
  float distance;        ///< metres to the lamp, minus what rounding needs
  Color light_over_pdf;  ///< radiance (irradiance of a surface that faces it, if it has no size) over density
  float pdf = 0;         ///< 1/sr; infinite for lamps without size; 0: no light
};

/// All lights inside the scene: emissive triangles, point and spot lights, which a LampTree chooses from; and
/// directional lights.
struct Lamps {
  struct Emitter {
    std::int32_t placement;  ///< of a triangle; −1: a point or spot light
    std::uint32_t index;     ///< of the triangle, or into `points`
  };
  std::vector<Emitter> emitters;
  std::vector<PunctualLight> points, directions;  ///< point and spot lights; directional lights
  std::vector<float> direction_cdf;               ///< to choose from `directions` by luminance, 0 to 1
  std::vector<std::int32_t> first_emitter;        ///< of every placement's triangles; −1: emits nothing
  LampTree tree;

  /// Draws a lamp of the tree and a point on it, for a surface at `point` facing `normal`. `u_choice` and `u`
  /// are uniform in [0, 1).
  LampSample sample(const PlacedGeometry& placed, const Vec3& point, const Vec3& normal, float u_choice,
                    const Eigen::Vector2f& u) const;

  /// Draws one of the directional lights. There must be one.
  LampSample sample_direction(float u) const;

  /// Density per solid angle with which sample() draws the point `at` of a triangle, seen from `point`; 0 for
  /// triangles that it never draws.
  float pdf(const PlacedGeometry& placed, const Vec3& point, const Vec3& normal, std::uint32_t placement,
            std::uint32_t triangle, const Vec3& at) const;
};

Lamps make_lamps(const Scene& scene, const PlacedGeometry& placed);

}  // namespace cps
