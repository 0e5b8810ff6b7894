#pragma once

#include <algorithm>

#include "renderer/paths/direct_light.h"

/// The steps of path tracing, and the loop around them.
namespace cps {

/// Shadow rays of a vertex that are traced together with those of other paths.
struct SunAndSkyRays {
  ShadowRay sun, sky;
};

/// The surfaces that the living paths meet next. `coherent`: their rays have similar origins and directions.
/// Prefetches what shading them will read.
void next_hits(const RenderScene& scene, bool coherent, Path (&paths)[packet_size], Hit (&hits)[packet_size]);

/// Adds the light of sun and sky to a path that met nothing, and ends it.
void leave_scene(const RenderScene& scene, Path& path);

/// Looks up the surface that the path hit and adds the light that it emits. Returns whether the path may
/// scatter there; if not, it has ended or goes straight on. `surface` is set if it returns true.
bool meet_surface(const RenderScene& scene, int max_shaded_vertices, Path& path, const Hit& hit,
                  Surface& surface);

/// Sends the path from a diffuse surface that has scattered it, in a direction drawn with density `pdf`.
/// Leaves Ray::id to the caller.
void send_from_diffuse(Path& path, const Surface& surface, const Vec3& direction, float pdf);

/// Adds the light that lamps send to the surface and sends the path on.
SunAndSkyRays light_and_scatter(const RenderScene& scene, Path& path, const Surface& surface);

/// meet_surface() and light_and_scatter() in turn.
inline SunAndSkyRays shade_vertex(const RenderScene& scene, int max_shaded_vertices, Path& path,
                                  const Hit& hit) {
  Surface surface;
  if (!meet_surface(scene, max_shaded_vertices, path, hit, surface)) return {};
  return light_and_scatter(scene, path, surface);
}

/// Traces the paths that are alive to their ends. `shade(path, hit)` deals with each surface that one hits
/// and returns the SunAndSkyRays to trace. `coherent_start`: as for next_hits(), of the first rays and the
/// sun rays from what they hit.
template <typename Shade>
void trace_paths_with(const RenderScene& scene, bool coherent_start, Path (&paths)[packet_size],
                      Shade&& shade) {
  const auto is_alive = [](const Path& path) { return path.alive; };
  for (bool coherent = coherent_start; std::ranges::any_of(paths, is_alive); coherent = false) {
    // Find the next surface of every path.
    Hit hits[packet_size];
    next_hits(scene, coherent, paths, hits);

    // Shade it, or end the path in the sky.
    ShadowRay sun_rays[packet_size], sky_rays[packet_size];
    for (int i = 0; i < packet_size; ++i) {
      if (!paths[i].alive) continue;
      if (!hits[i]) {
        leave_scene(scene, paths[i]);
        continue;
      }
      const SunAndSkyRays rays = shade(paths[i], hits[i]);
      sun_rays[i] = rays.sun;
      sky_rays[i] = rays.sky;
      ++paths[i].met_surfaces;
    }

    // Add the light of sun and sky where nothing stands in the way. The sun's rays from first surfaces run
    // side by side.
    gather_all(scene, sun_rays, coherent, &VertexRecord::sun, paths);
    gather_all(scene, sky_rays, false, &VertexRecord::sky, paths);
  }
}

}  // namespace cps
