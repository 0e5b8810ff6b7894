#pragma once

#include <tbb/concurrent_unordered_map.h>

#include <atomic>
#include <optional>
#include <string>

#include "renderer/cache/cell_light.h"
#include "renderer/cache/cell_sizes.h"

namespace cps {

struct Surface;

struct LightCacheOptions {
  double memory_gib = 1;  ///< for cells

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

struct LightCacheSummary {
  std::uint64_t cells = 0;  ///< kept
  double cpu_s = 0;         ///< spent on computing cells
};

/// Light of a scene in one condition, kept in cells of world space and computed when it is first asked for. A
/// cell's light is a pure function of scene, light and cell (cell_light.h): it does not matter who asks,
/// in which order, and what is forgotten meanwhile. Any number of threads may ask.
class LightCache {
 public:
  /// `scene` and `lit` are the same scene; `lit` must outlive the cache.
  LightCache(const Scene& scene, const RenderScene& lit, int max_shaded_vertices,
             LightCacheOptions options = {});

  /// Forgets all cells if they take most of the memory. Not while the scene is rendered.
  void make_room();

  /// As shade_vertex() of a path in the scene, but takes the light of a diffuse base from the cache wherever
  /// it knows it. The layer above, mirrors and glass lead on to the next surface.
  SunAndSkyRays shade(Path& path, const Hit& hit);

  LightCacheSummary summary() const;

 private:
  struct Hash {
    std::size_t operator()(const Cell& cell) const { return cell.hash(); }
  };

  /// What cells say of the light at a surface that the path has hit: radiance of white paper there, without
  /// sun and lamps. Empty where the light may change within the smallest cells; then paths must find it. Adds
  /// the rays traced for it to path.rays.
  std::optional<Color> light_at(Path& path, const Hit& hit, const Surface& surface);

  CellLight light_of(const Cell& cell, Path& path);

  const RenderScene& scene_;
  CellSizes sizes_;
  int max_shaded_vertices_;
  std::size_t max_cells_;
  std::atomic<std::int64_t> cpu_ns_ = 0;
  tbb::concurrent_unordered_map<Cell, CellLight, Hash> cells_;
};

}  // namespace cps
