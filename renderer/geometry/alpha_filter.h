#pragma once

#include <embree3/rtcore.h>

#include "renderer/geometry/geometry.h"

namespace cps {

/// What a shadow ray query carries: the light left after the half-transparent surfaces and the glass met so
/// far, by ray id.
struct ShadowContext {
  RTCIntersectContext embree;  ///< first, so that filters find the rest behind it
  Color transmittance[8];
};

/// Share of a surface that is there at a hit: 1 where it is opaque, what its alpha says elsewhere.
float coverage(const Geometry& geometry, std::uint32_t triangle, float u, float v);

void init_shadow_context(ShadowContext& context);

/// Lets rays through the holes of masked geometry, and through half-transparent geometry: a nearest-hit ray
/// by chance (a hash of ray id and triangle), a shadow ray with the share that is left. Glass stops
/// nearest-hit rays and tints shadow rays. Does nothing for geometry that is opaque.
void set_alpha_filters(RTCGeometry embree, const Geometry& geometry);

}  // namespace cps
