#pragma once

#include "renderer/geometry/geometry.h"
#include "renderer/geometry/ray.h"

namespace cps {

/// Texture coordinates at the hit, and the footprint of the ray's cone in their units (ray cones:
/// Akenine-Möller et al. 2019). A slanted surface stretches the footprint away from the viewer. One lookup
/// averages a round area as large as its part of the footprint; surfaces that the viewer sees at a steep
/// slant (roads) get several lookups in a row.
/// `width`: metres that the cone spans at the hit; `cosine`: of the ray to the surface normal, positive.
TextureFootprint texture_footprint(const WorldTriangle& t, const Hit& hit, const Ray& ray, float width,
                                   float cosine);

}  // namespace cps
