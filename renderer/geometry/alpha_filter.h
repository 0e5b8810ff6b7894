#pragma once

#include <embree3/rtcore.h>

#include "renderer/geometry/geometry.h"
#include "renderer/geometry/ray.h"

namespace cps {

/// State of a query for shadow rays: the light left, by ray id, after the half-transparent surfaces and the
/// glass met so far.
struct ShadowContext {
  RTCIntersectContext embree;  ///< must be first: filters get a pointer to it and cast it to the whole
  Color transmittance[packet_size];

  ShadowContext();
};

/// Installs Embree filters that let rays through the holes of masked geometry and through half-transparent
/// geometry: a nearest-hit ray by chance (a hash of ray id and triangle), a shadow ray with the share of
/// light that is left. Glass stops nearest-hit rays and tints shadow rays. Installs none on opaque geometry.
void set_alpha_filters(RTCGeometry embree, const Geometry& geometry);

}  // namespace cps
