#pragma once

#include "renderer/cache/light_cache.h"

namespace cps {

/// As trace_paths(), but takes the diffuse reflection of sky, indirect and unsampled light from the cache
/// wherever it knows it. The layer above a diffuse base, mirrors and glass lead on to the next surface.
void trace_cached_paths(const RenderScene& scene, LightCache& cache, int max_shaded_vertices,
                        Path (&paths)[packet_size]);

}  // namespace cps
