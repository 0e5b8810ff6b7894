#include "renderer/paths/path.h"

#include <algorithm>
#include <cmath>

#include "renderer/paths/direct_light.h"
#include "renderer/paths/surface.h"

namespace cps {
namespace {

/// Angle by which a bounce widens the footprint for texture lookups: about a quarter of the lobe's width.
/// What a wide lobe sees is averaged anyway, so only the cost of fine mip levels is at stake.
constexpr float diffuse_spread = 0.25f;

/// Mirrors seen by way of a diffuse surface count as this rough. The pools of sunlight that they throw would
/// otherwise be found by one path in thousands and speckle the picture; so they are spread out instead
/// (Kaplanyan & Dachsbacher 2013, "Path space regularization"). What the camera sees directly or in mirrors
/// keeps its gloss.
constexpr float roughness_after_diffuse = 0.6f;

void end_path(Path& path, const char* why) {
  path.alive = false;
  if (path.record) path.record->end = why;
}

/// The path's cone after a lobe of this width, and the roughness that it leaves to what comes.
void widen(Path& path, float lobe, float least_roughness) {
  path.cone_spread += diffuse_spread * lobe;
  path.least_roughness = std::max(path.least_roughness, least_roughness);
}

/// Whether a surface has light for a path that shall be shaded no more: its own, or what it lets through.
bool gives_light(const RenderScene& scene, const Hit& hit) {
  const SurfaceMaterial& material =
      *scene.placed.geometries[scene.placed.placements[hit.placement].geometry].material;
  return material.emits || material.unlit || material.transmits;
}

/// After its last shaded vertex a path only goes on straight.
void pass_straight(Path& path, const Surface& surface) {
  path.throughput *= surface.bsdf.straight;
  path.ray = surface.pass(path.ray);
  if (!(path.throughput > 0.0f).any()) end_path(path, "no more bounces");
}

/// Russian roulette: a path goes on with a probability that is linear in its throughput, up to certainty. The
/// best one is in proportion to what a path may still bring over the root of what that costs (Rath et al.
/// 2022, "EARS: efficiency-aware Russian roulette and splitting"). The factors are those that reached an
/// error soonest on a street: lower before what a bounce has found is shaded, which takes half of the time
/// for a tenth of the light, than before a ray that may find the sky.
constexpr float roulette_before_shading = 3.0f, roulette_before_ray = 9.0f;

/// Whether the path survives; `number` says which of the vertex' two for this purpose it draws.
bool survives_roulette(Path& path, float per_throughput, std::uint32_t first_pair, int number) {
  const float survival = per_throughput * path.throughput.maxCoeff();
  if (survival >= 1.0f) return true;
  if (path.sampler.pair(first_pair + pair_roulette)[number] >= survival) {
    end_path(path, "Russian roulette");
    return false;
  }
  path.throughput /= survival;
  return true;
}

/// Sends the path on in a direction of the BSDF's choice, or straight through glass, or ends it. What passes
/// glass goes on as if nothing had been there: shadow rays pass it too, so the density with which the last
/// vertex drew the direction still holds.
void scatter(Path& path, const Surface& surface, std::uint32_t first_pair) {
  const Eigen::Vector2f direction_pair = first_pair == pair_first_vertex
                                             ? path.sampler.joint_pair(joint_first_direction)
                                             : path.sampler.pair(first_pair + pair_bsdf);
  const float lobe =
      surface.bsdf.diffuse_probability < 1.0f ? path.sampler.pair(first_pair + pair_lobe).x() : 0.0f;
  const BsdfSample sample = sample_bsdf(surface.bsdf, surface.wo, lobe, direction_pair);
  if (sample.kind == BsdfSample::Kind::straight) {
    path.throughput *= sample.weight;
    path.ray = surface.pass(path.ray);
    return;
  }
  const Vec3 direction = surface.shading.to_world(sample.wi);
  if (!(sample.pdf > 0.0f && surface.geometric_normal.dot(direction) > 0.0f))
    return end_path(path, "scattered into the surface");
  path.throughput *= sample.weight;

  if (path.shaded_vertices > 0 && !survives_roulette(path, roulette_before_ray, first_pair, 1)) return;
  path.ray = surface.leave(direction);
  path.pdf = sample.pdf;
  path.vertex_position = surface.position;
  path.vertex_normal = surface.geometric_normal;
  ++path.shaded_vertices;
  switch (sample.kind) {
    case BsdfSample::Kind::layer:
      return widen(path, surface.bsdf.alpha, 0.5f * surface.bsdf.roughness);
    case BsdfSample::Kind::coat:
      return widen(path, surface.bsdf.coat.alpha, 0.5f * surface.bsdf.coat.roughness);
    default:
      return widen(path, 1.0f, roughness_after_diffuse);
  }
}

/// The surface that shows where `hit` is the nearest. glTF hides the backs of single-sided materials from the
/// viewer; light between surfaces meets them like fronts, so that a wall without a back casts a shadow and
/// lets nothing through. A front may lie in the very place of a hidden back (cloth made of two), so the ray
/// starts anew.
Hit first_visible(const RenderScene& scene, const Path& path, const Hit& hit, std::uint64_t& rays) {
  if (!hit || !is_culled(scene.placed, path.ray, hit)) return hit;
  ++rays;
  return scene.bvh.intersect_shown(path.ray);
}

void record_vertex(Path& path, const Hit& hit, const Surface& surface, const Color& emission) {
  path.record->vertices.push_back({.hit = hit,
                                   .position = surface.position,
                                   .normal = surface.geometric_normal,
                                   .footprint_m = path.cone_width,
                                   .throughput = path.throughput,
                                   .emission = emission});
}

/// The surfaces that the living paths see next. What their shading will fetch is on its way to the cache when
/// it returns.
std::uint64_t next_hits(const RenderScene& scene, bool first, const Path (&paths)[packet_size],
                        Hit (&hits)[packet_size]) {
  std::uint64_t rays = first ? first_hits(scene, paths, hits) : 0;
  for (int i = 0; i < packet_size; ++i) {
    if (!paths[i].alive) continue;
    if (!first) {
      hits[i] = scene.bvh.intersect(paths[i].ray);
      ++rays;
      if (paths[i].ray.from_viewer) hits[i] = first_visible(scene, paths[i], hits[i], rays);
    }
    if (hits[i]) prefetch_corners(scene.placed, hits[i].placement, hits[i].triangle);
  }
  for (int i = 0; i < packet_size; ++i)
    if (paths[i].alive && hits[i]) prefetch_vertices(scene.placed, hits[i].placement, hits[i].triangle);
  return rays;
}

}  // namespace

std::uint64_t first_hits(const RenderScene& scene, const Path (&paths)[packet_size],
                         Hit (&hits)[packet_size]) {
  Ray lanes[packet_size];
  bool active[packet_size];
  for (int i = 0; i < packet_size; ++i) lanes[i] = paths[i].ray, active[i] = paths[i].alive;
  scene.bvh.intersect_coherent(lanes, active, hits);
  std::uint64_t rays = 0;
  for (int i = 0; i < packet_size; ++i) {
    if (!active[i]) continue;
    ++rays;
    hits[i] = first_visible(scene, paths[i], hits[i], rays);
  }
  return rays;
}

std::uint64_t trace_paths(const RenderScene& scene, int max_shaded_vertices, Path (&paths)[packet_size]) {
  std::uint64_t rays = 0;
  const bool has_lamps = !scene.lamps.tree.empty() || !scene.lamps.directions.empty();
  const auto any_alive = [&] {
    return std::any_of(std::begin(paths), std::end(paths), [](const Path& p) { return p.alive; });
  };
  for (std::uint32_t step = 0; any_alive(); ++step) {
    const bool first = step == 0;
    const std::uint32_t first_pair = pair_first_vertex + pairs_per_vertex * step;
    Hit hits[packet_size];
    rays += next_hits(scene, first, paths, hits);

    ShadowRay sun_rays[packet_size], sky_rays[packet_size];
    for (int i = 0; i < packet_size; ++i) {
      Path& path = paths[i];
      if (!path.alive) continue;
      if (!hits[i]) {
        const Color light = path.throughput * light_from_beyond(scene, path);
        path.radiance += light;
        if (path.record) path.record->beyond = light;
        end_path(path, "left the scene");
        continue;
      }
      const bool is_last = path.shaded_vertices == max_shaded_vertices;
      if (is_last && !gives_light(scene, hits[i])) {
        end_path(path, "no more bounces");
        continue;
      }
      if (path.shaded_vertices > 0 && !gives_light(scene, hits[i]) &&
          !survives_roulette(path, roulette_before_shading, first_pair, 0)) {
        continue;
      }
      path.cone_width += path.cone_spread * hits[i].t;
      const Surface surface =
          make_surface(scene.placed, path.ray, hits[i], path.cone_width, path.least_roughness);
      const Color emission = path.throughput * light_from_lamp(scene, path, hits[i], surface);
      path.radiance += emission;
      if (path.record) record_vertex(path, hits[i], surface, emission);
      if (!surface.scatters) {
        end_path(path, "unlit");
        continue;
      }
      if (is_last) {
        pass_straight(path, surface);
        continue;
      }
      sun_rays[i] = towards_sun(scene, path, surface, first_pair);
      sky_rays[i] = towards_sky(scene, path, surface, first_pair);
      if (has_lamps) gather_lamps(scene, path, surface, first_pair, rays);
      scatter(path, surface, first_pair);
    }
    gather_all(scene, sun_rays, first, &VertexRecord::sun, paths, rays);
    gather_all(scene, sky_rays, false, &VertexRecord::sky, paths, rays);
  }
  return rays;
}

}  // namespace cps
