#pragma once

#include "renderer/geometry/trace.h"
#include "renderer/materials/bsdf.h"
#include "renderer/math/frame.h"

namespace cps {

/// The point where a path hits a surface, with all that shading needs.
struct Surface {
  Vec3 position;
  Vec3 geometric_normal;  ///< on the ray's side
  Frame shading;
  Vec3 wo;           ///< back along the ray, in the shading frame
  Bsdf bsdf;         ///< not set if `scatters` is false
  bool scatters;     ///< false for unlit materials, which reflect nothing
  Color base_color;  ///< glTF's, with texture and vertex colours
  Color emission;    ///< radiance towards wo
  float clearance;   ///< distance that a ray must start off the surface, for rounding, metres
  bool meets_car;    ///< of the ray that hit it, and of those that leave it

  /// A ray away from the surface. `wi` must be on wo's side of the true surface, or light leaks through.
  Ray leave(const Vec3& wi) const {
    return {.origin = position + clearance * geometric_normal, .direction = wi, .meets_car = meets_car};
  }

  /// `ray`, which hit the surface, continued straight through it.
  Ray pass(const Ray& ray) const {
    Ray onward = ray;
    onward.origin = position - clearance * geometric_normal;
    onward.t_near = 0;
    return onward;
  }
};

/// The surface at a hit of `ray`. Textures are averaged over the ray's width there, `footprint_width` metres;
/// roughness is at least `min_roughness`.
Surface make_surface(const PlacedGeometry& placed, const Ray& ray, const Hit& hit, float footprint_width,
                     float min_roughness);

/// Whether the hit is on the back of a single-sided material, which glTF does not show.
bool is_culled(const PlacedGeometry& placed, const Ray& ray, const Hit& hit);

}  // namespace cps
