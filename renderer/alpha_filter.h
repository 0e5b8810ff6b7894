#pragma once

#include <embree3/rtcore.h>

#include "renderer/geometry.h"

namespace cps {

/// What a shadow ray query carries: the light left after the half-transparent surfaces met so far, by ray id.
struct ShadowContext {
  RTCIntersectContext embree;  ///< first, so that filters find the rest behind it
  float transmittance[8];
};

void init_shadow_context(ShadowContext& context);

/// Lets rays through the holes of masked geometry, and through half-transparent geometry: a nearest-hit ray
/// by chance (a hash of ray id and triangle), a shadow ray with the share that is left.
void set_alpha_filters(RTCGeometry embree, const Geometry& geometry);

}  // namespace cps
