#include "renderer/cache/cached_paths.h"

#include "renderer/paths/path_steps.h"

namespace cps {

void trace_cached_paths(const RenderScene& scene, LightCache& cache, int max_shaded_vertices,
                        Path (&paths)[packet_size]) {
  trace_paths_with(scene, true, paths, [&](Path& path, const Hit& hit) -> SunAndSkyRays {
    Surface surface;
    if (!meet_surface(scene, max_shaded_vertices, path, hit, surface)) return {};
    const Color albedo = base_albedo(surface.bsdf);
    const auto light = (albedo > 0.0f).any() ? cache.light_at(path, hit, surface) : std::nullopt;
    if (light) {
      const Color reflected = path.throughput * albedo * *light;
      path.radiance += reflected;
      if (path.record) path.record->vertices.back().cached = reflected;
      surface.bsdf.draws_base = false;
    }
    return light_and_scatter(scene, path, surface);
  });
}

}  // namespace cps
