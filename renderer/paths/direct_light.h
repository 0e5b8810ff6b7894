#pragma once

#include "renderer/paths/path.h"
#include "renderer/paths/surface.h"

/// Direct light at a path's vertices: shadow rays to sun, sky and lamps, and the weights that combine them
/// with the rays that hit lights by chance (multiple importance sampling, Veach 1997).
namespace cps {

/// Light on its way to a vertex, which arrives if nothing stands between.
struct ShadowRay {
  Ray ray;
  Color contribution;  ///< to the pixel
  bool wanted = false;
};

/// Sky and sun where the path leaves the scene, weighed against next-event estimation at its last vertex.
Color light_from_beyond(const RenderScene& scene, const Path& path);

/// Emission of the surface that the path hit, weighed against next-event estimation at its last vertex.
Color light_from_lamp(const RenderScene& scene, const Path& path, const Hit& hit, const Surface& surface);

/// Shadow rays from a vertex.
ShadowRay towards_sun(const RenderScene& scene, const Path& path, const Surface& surface);
ShadowRay towards_sky(const RenderScene& scene, const Path& path, const Surface& surface);

/// Adds the light of one of the scene's lamps that have a place, and of one of its directional lights.
void gather_lamps(const RenderScene& scene, Path& path, const Surface& surface);

/// Traces the shadow rays and adds what they bring to the paths. `kind`: where records note it. `coherent`:
/// the rays have similar origins and directions.
void gather_all(const RenderScene& scene, const ShadowRay (&shadows)[packet_size], bool coherent,
                Color VertexRecord::*kind, Path (&paths)[packet_size]);

}  // namespace cps
