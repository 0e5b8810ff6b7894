#pragma once

#include "renderer/geometry/trace.h"
#include "renderer/materials/bsdf.h"
#include "renderer/math/frame.h"

namespace cps {

/// The point where a path meets matter, and all that its light needs there.
struct Surface {
  Vec3 position;
  Vec3 geometric_normal;  ///< on the ray's side
  Frame shading;
  Vec3 wo;           ///< back along the ray, in the shading frame
  Bsdf bsdf;         ///< not set where `scatters` is false
  bool scatters;     ///< false for unlit materials, which take no light
  Color base_color;  ///< glTF's, with texture and vertex colours
  Color emission;    ///< radiance towards wo
  float clearance;   ///< metres that a ray must start off the surface, by rounding of the coordinates

  /// A ray away from here. Ends the light's leak through the surface: `wi` must be on wo's side of the true
  /// surface.
  Ray leave(const Vec3& wi) const { return {position + clearance * geometric_normal, wi}; }

  /// `ray`, which came here, on its way straight through.
  Ray pass(const Ray& ray) const {
    Ray onward = ray;
    onward.origin = position - clearance * geometric_normal;
    onward.t_near = 0;
    return onward;
  }
};

/// The surface at a hit of `ray`, which is `footprint_width` metres wide there (its textures are averaged
/// over that). Its roughness is at least `min_roughness`.
Surface make_surface(const PlacedGeometry& placed, const Ray& ray, const Hit& hit, float footprint_width,
                     float min_roughness);

/// Whether the hit is on the back of a single-sided material, which glTF does not show.
bool is_culled(const PlacedGeometry& placed, const Ray& ray, const Hit& hit);

}  // namespace cps
