#pragma once

#include <limits>
#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/lights/lamp_tree.h"

namespace cps {

/// Light that a lamp may send to a point.
struct LampSample {
  Vec3 direction;        ///< to the lamp
  float distance;        ///< to where the lamp begins, a little short of it
  Color light_over_pdf;  ///< radiance (or irradiance facing it, of lamps without size) over the density
  float pdf = 0;         ///< per solid angle; infinite for lamps without size; 0: no light
};

/// All that shines inside the scene: emissive triangles and lamps without size, chosen by a LampTree, and
/// directional lights.
struct Lamps {
  struct Emitter {           ///< a triangle, or a light of the scene
    std::int32_t placement;  ///< −1: a light
    std::uint32_t index;
  };
  std::vector<Emitter> emitters;
  std::vector<PunctualLight> points, directions;
  std::vector<float> direction_cdf;         ///< of `directions` by luminance, 0 to 1
  std::vector<std::int32_t> first_emitter;  ///< of every placement's triangles; −1: it does not shine
  LampTree tree;

  /// A lamp of the tree, for a surface at `point` facing `normal`. `u_choice` and `u` are uniform.
  LampSample sample(const PlacedGeometry& placed, const Vec3& point, const Vec3& normal, float u_choice,
                    const Eigen::Vector2f& u) const;

  /// One of the directional lights.
  LampSample sample_direction(float u) const;

  /// Density per solid angle with which sample() finds the place `at` on a triangle from `point`; 0 for what
  /// it never finds.
  float pdf(const PlacedGeometry& placed, const Vec3& point, const Vec3& normal, std::uint32_t placement,
            std::uint32_t triangle, const Vec3& at) const;
};

Lamps make_lamps(const Scene& scene, const PlacedGeometry& placed);

}  // namespace cps
