#include "renderer/cache/light_cache.h"

#include <algorithm>
#include <cmath>

#include "numbers/cpu_time.h"
#include "renderer/paths/hit_ids.h"
#include "renderer/paths/path_steps.h"

namespace cps {
namespace {

/// Cells that are near others are divided down to so many levels below.
constexpr int max_divisions = 2;

/// What a path sees after it scattered is a small part of the picture, or averaged over a lobe: larger cells
/// do, however near others are.
constexpr int levels_after_bounce = 2;

/// Light of the base is known, so that all that is left to chance is the layer above: it is drawn more often
/// than by its share of the light.
constexpr float layer_draws = 3;

/// Room to each side of the car within which its shadow in the sky's light counts.
constexpr float car_room_m = 3;

/// Where levels change, they mix over this part of the way from one to the next.
constexpr float mixed_share = 0.25f;

constexpr double bytes_per_cell = sizeof(std::pair<const Cell, CellLight>) + 3 * sizeof(void*);

/// Random pairs that no path uses (random_pairs.h), at the n-th surface pair(2 n + …).
enum LookupPair : std::uint32_t { pair_place = 1u << 21, pair_level, pairs_per_lookup = 2 };

Eigen::Vector2f lookup_pair(const Path& path, LookupPair which) {
  return path.random.pair(which + pairs_per_lookup * static_cast<std::uint32_t>(path.met_surfaces));
}

int drawn_level(float level, float u) {
  const float whole = std::floor(level), part = level - whole;
  const float upper_share = std::clamp((part - (1 - mixed_share)) / mixed_share, 0.0f, 1.0f);
  return std::max(0, static_cast<int>(whole) + (u < upper_share));
}

/// Leaves hang in all directions and near each other: light is taken as it is in the mean over their cell.
bool is_foliage(const SurfaceMaterial& material) {
  return material.alpha_mode == AlphaMode::mask && material.double_sided;
}

/// Radiance of white paper whose normal is tilted against the cell's surface.
Color tilted(const CellLight& light, const Vec3& normal, const Vec3& geometric_normal) {
  const float along = light.towards.dot(geometric_normal);
  if (along <= 0.05f) return light.radiance;
  return light.radiance * std::clamp(light.towards.dot(normal) / along, 0.0f, 2.0f);
}

}  // namespace

std::string LightCacheOptions::fault() const {
  return memory_gib >= 0.01 && memory_gib <= 1024 ? "" : "cache_memory: must lie in [0.01, 1024] GiB";
}

LightCache::LightCache(const Scene& scene, const RenderScene& lit, int max_shaded_vertices,
                       LightCacheOptions options)
    : scene_(lit),
      sizes_(make_cell_sizes(scene)),
      max_shaded_vertices_(max_shaded_vertices),
      max_cells_(static_cast<std::size_t>(options.memory_gib * 0x1p30 / bytes_per_cell)) {}

void LightCache::make_room() {
  if (cells_.size() > max_cells_ / 4 * 3) cells_.clear();
}

LightCacheSummary LightCache::summary() const {
  return {cells_.size(), 1e-9 * static_cast<double>(cpu_ns_)};
}

CellLight LightCache::light_of(const Cell& cell, Path& path) {
  if (const auto kept = cells_.find(cell); kept != cells_.end()) return kept->second;
  // Far light is traced to its end; near light finds far light where its paths hit something.
  const auto shade = [&](Path& from_cell, const Hit& hit) {
    return cell.is_far ? shade_vertex(scene_, max_shaded_vertices_, from_cell, hit)
                       : this->shade(from_cell, hit);
  };
  const double begin_s = cpu_s(CLOCK_THREAD_CPUTIME_ID);
  const CellLight light = compute_cell_light(scene_, cell, shade, path.rays);
  // Paths that do not meet the car are those of a cell, whose time includes that of the cells it asks for.
  if (path.ray.meets_car)
    cpu_ns_ += static_cast<std::int64_t>(1e9 * (cpu_s(CLOCK_THREAD_CPUTIME_ID) - begin_s));
  if (cells_.size() < max_cells_) cells_.emplace(cell, light);
  return light;
}

SunAndSkyRays LightCache::shade(Path& path, const Hit& hit) {
  Surface surface;
  if (!meet_surface(scene_, max_shaded_vertices_, path, hit, surface)) return {};
  const Color albedo = base_albedo(surface.bsdf);
  const auto light = (albedo > 0.0f).any() ? light_at(path, hit, surface) : std::nullopt;
  if (light) {
    const Color reflected = path.throughput * albedo * *light;
    path.radiance += reflected;
    if (path.record) path.record->vertices.back().cached = reflected;
    leave_out_base(surface.bsdf, layer_draws);
  }
  return light_and_scatter(scene_, path, surface);
}

std::optional<Color> LightCache::light_at(Path& path, const Hit& hit, const Surface& surface) {
  const Placement& placement = scene_.placed.placements[hit.placement];
  const Geometry& geometry = scene_.placed.geometries[placement.geometry];
  if (placement.rides || geometry.viewer_only) return {};
  if (!scene_.car_bounds.isEmpty() && scene_.car_bounds.exteriorDistance(surface.position) < car_room_m)
    return {};

  const bool is_far = path.shaded_vertices > 0;
  const Eigen::Vector2f place = lookup_pair(path, pair_place) - Eigen::Vector2f::Constant(0.5f);
  const std::uint32_t facing = facing_of(surface.geometric_normal), material = ids_of(scene_, hit).material;
  const Frame plane = frame_around(surface.geometric_normal);
  const int level = drawn_level(sizes_.level_at(surface.position), lookup_pair(path, pair_level).x()) +
                    (is_far ? levels_after_bounce : 0);
  if (is_far && hit.t < 2 * cell_size_m(level)) return {};
  const int last = is_far ? level : std::max(0, level - max_divisions);
  for (int l = level; l >= last; --l) {
    // A place beside mixes neighbouring cells; where the surface ends, its own cell.
    const Vec3 beside =
        surface.position + cell_size_m(l) * (place.x() * plane.tangent + place.y() * plane.bitangent);
    CellLight light = light_of(cell_at(beside, l, facing, is_far, material), path);
    if (!light.is_known) light = light_of(cell_at(surface.position, l, facing, is_far, material), path);
    if (light.is_known && (!light.is_near || is_far || is_foliage(*geometry.material)))
      return tilted(light, surface.shading.normal, surface.geometric_normal);
  }
  return {};
}

}  // namespace cps
