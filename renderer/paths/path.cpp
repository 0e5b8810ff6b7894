#include "renderer/paths/path.h"

#include <algorithm>

#include "renderer/paths/path_steps.h"

namespace cps {
namespace {

/// Angle by which a bounce widens the footprint of later texture lookups, relative to the lobe's width. A
/// wide lobe averages what it sees anyway: this only saves lookups in fine mip levels.
constexpr float diffuse_spread = 0.25f;

/// Mirrors seen by way of a diffuse surface count as at least this rough. Few paths in thousands would find
/// the caustics that they throw, which speckles the picture; so they are blurred instead (Kaplanyan &
/// Dachsbacher 2013, "Path space regularization"). What the camera sees directly or in mirrors keeps its
/// gloss.
constexpr float roughness_after_diffuse = 0.6f;

/// Russian roulette: a path survives with a probability that is linear in its throughput, up to 1. The best
/// probability is in proportion to what the path may still bring over the root of its cost (Rath et al.
/// 2022, "EARS: efficiency-aware Russian roulette and splitting"). These factors gave the lowest error in
/// equal time on a street. The first is lower, since shading what a bounce has hit takes half of the time
/// for a tenth of the light; a ray may still find the sky.
constexpr float roulette_before_shading = 3.0f, roulette_before_ray = 9.0f;

void end_path(Path& path, const char* why) {
  path.alive = false;
  if (path.record) path.record->end = why;
}

/// Plays Russian roulette with x or y (`number`) of the pair for it. Returns whether the path survives.
bool survives_roulette(Path& path, float per_throughput, int number) {
  const float survival = per_throughput * path.throughput.maxCoeff();
  if (survival >= 1.0f) return true;
  if (path.pair(pair_roulette)[number] >= survival) {
    end_path(path, "Russian roulette");
    return false;
  }
  path.throughput /= survival;
  return true;
}

/// Whether a surface gives light to a path that may be shaded no more: its own, or what it lets through.
bool gives_light(const RenderScene& scene, const Hit& hit) {
  const SurfaceMaterial& material =
      *scene.placed.geometries[scene.placed.placements[hit.placement].geometry].material;
  return material.emits || material.unlit || material.transmits;
}

/// Widens the path's cone by a lobe of this width, and sets a lower limit to the roughness of later surfaces.
void widen(Path& path, float lobe, float min_roughness) {
  path.cone_spread += diffuse_spread * lobe;
  path.min_roughness = std::max(path.min_roughness, min_roughness);
}

void widen_diffusely(Path& path) {
  widen(path, 1.0f, roughness_after_diffuse);
}

void widen(Path& path, const Bsdf& bsdf, BsdfSample::Kind kind) {
  switch (kind) {
    case BsdfSample::Kind::layer:
      return widen(path, bsdf.alpha, 0.5f * bsdf.roughness);
    case BsdfSample::Kind::coat:
      return widen(path, bsdf.coat.alpha, 0.5f * bsdf.coat.roughness);
    default:
      return widen_diffusely(path);
  }
}

/// Sends the path from a surface that has scattered it, in a direction drawn with density `pdf`.
void send_on(Path& path, const Surface& surface, const Vec3& direction, float pdf) {
  path.ray = surface.leave(direction);
  path.pdf = pdf;
  path.skips_sun_and_lamps = false;
  path.vertex_position = surface.position;
  path.vertex_normal = surface.geometric_normal;
  ++path.shaded_vertices;
}

BsdfSample draw_direction(const Path& path, const Surface& surface) {
  const Eigen::Vector2f direction =
      path.met_surfaces == 0 ? path.random.joint_pair(joint_first_bsdf) : path.pair(pair_bsdf);
  const float lobe = surface.bsdf.diffuse_probability < 1.0f ? path.pair(pair_lobe).x() : 0.0f;
  return sample_bsdf(surface.bsdf, surface.wo, lobe, direction);
}

/// Sends the path on in a direction drawn from the BSDF, or straight through glass, or ends it.
void scatter(Path& path, const Surface& surface) {
  const BsdfSample sample = draw_direction(path, surface);

  // Through glass the path goes on as if nothing had been there. Shadow rays pass it too, so the density with
  // which the last vertex drew the direction still holds.
  if (sample.kind == BsdfSample::Kind::straight) {
    path.throughput *= sample.weight;
    path.ray = surface.pass(path.ray);
    return;
  }

  // Below the true surface there is nothing to light.
  const Vec3 direction = surface.shading.to_world(sample.wi);
  if (!(sample.pdf > 0.0f && surface.geometric_normal.dot(direction) > 0.0f))
    return end_path(path, "scattered into the surface");
  path.throughput *= sample.weight;

  // The first bounce finds most of the light: only later ones may be cut.
  if (path.shaded_vertices > 0 && !survives_roulette(path, roulette_before_ray, 1)) return;

  // Half-transparent surfaces decide anew about each ray of the path.
  const auto next_id = static_cast<std::uint32_t>(mix64(std::uint64_t{path.ray.id} + 1));
  send_on(path, surface, direction, sample.pdf);
  path.ray.id = next_id;
  widen(path, surface.bsdf, sample.kind);
}

/// After its last shaded vertex a path only goes on straight.
void pass_straight(Path& path, const Surface& surface) {
  path.throughput *= surface.bsdf.straight;
  path.ray = surface.pass(path.ray);
  if (!(path.throughput > 0.0f).any()) end_path(path, "no more bounces");
}

void record_vertex(Path& path, const Hit& hit, const Surface& surface, const Color& emission) {
  path.record->vertices.push_back({.hit = hit,
                                   .position = surface.position,
                                   .normal = surface.geometric_normal,
                                   .footprint_m = path.cone_width,
                                   .throughput = path.throughput,
                                   .emission = emission});
}

/// The surface that shows where `hit` is the nearest. glTF hides the backs of single-sided materials from the
/// viewer; light between surfaces meets them like fronts, so that a wall without a back casts a shadow and
/// lets nothing through. A front may lie in the very place of a hidden back (cloth made of two), so the ray
/// starts anew.
Hit first_visible(const RenderScene& scene, Path& path, const Hit& hit) {
  if (!hit || !is_culled(scene.placed, path.ray, hit)) return hit;
  ++path.rays;
  return scene.bvh.intersect_shown(path.ray);
}

Hit next_hit(const RenderScene& scene, Path& path) {
  ++path.rays;
  const Hit hit = scene.bvh.intersect(path.ray);
  return path.ray.from_viewer ? first_visible(scene, path, hit) : hit;
}

}  // namespace

void first_hits(const RenderScene& scene, Path (&paths)[packet_size], Hit (&hits)[packet_size]) {
  Ray lanes[packet_size];
  bool active[packet_size];
  for (int i = 0; i < packet_size; ++i) lanes[i] = paths[i].ray, active[i] = paths[i].alive;
  scene.bvh.intersect_coherent(lanes, active, hits);
  for (int i = 0; i < packet_size; ++i) {
    if (!active[i]) continue;
    ++paths[i].rays;
    hits[i] = first_visible(scene, paths[i], hits[i]);
  }
}

void next_hits(const RenderScene& scene, bool coherent, Path (&paths)[packet_size],
               Hit (&hits)[packet_size]) {
  if (coherent) first_hits(scene, paths, hits);
  for (int i = 0; i < packet_size; ++i) {
    if (!paths[i].alive) continue;
    if (!coherent) hits[i] = next_hit(scene, paths[i]);
    if (hits[i]) prefetch_corners(scene.placed, hits[i].placement, hits[i].triangle);
  }
  for (int i = 0; i < packet_size; ++i)
    if (paths[i].alive && hits[i]) prefetch_vertices(scene.placed, hits[i].placement, hits[i].triangle);
}

void leave_scene(const RenderScene& scene, Path& path) {
  const Color light = path.throughput * light_from_beyond(scene, path);
  path.radiance += light;
  if (path.record) path.record->beyond = light;
  end_path(path, "left the scene");
}

bool meet_surface(const RenderScene& scene, int max_shaded_vertices, Path& path, const Hit& hit,
                  Surface& surface) {
  // Do not shade what can give no light or is not worth it.
  const bool is_last = path.shaded_vertices == max_shaded_vertices;
  if (is_last && !gives_light(scene, hit)) {
    end_path(path, "no more bounces");
    return false;
  }
  if (path.shaded_vertices > 0 && !gives_light(scene, hit) &&
      !survives_roulette(path, roulette_before_shading, 0)) {
    return false;
  }

  // Look up geometry, textures and BSDF, averaged over the path's cone.
  path.cone_width += path.cone_spread * hit.t;
  surface = make_surface(scene.placed, path.ray, hit, path.cone_width, path.min_roughness);

  // Add the light that the surface emits.
  const Color emission = path.throughput * light_from_lamp(scene, path, hit, surface);
  path.radiance += emission;
  if (path.record) record_vertex(path, hit, surface, emission);
  if (!surface.scatters) {
    end_path(path, "unlit");
    return false;
  }
  if (is_last) {
    pass_straight(path, surface);
    return false;
  }
  return true;
}

void send_from_diffuse(Path& path, const Surface& surface, const Vec3& direction, float pdf) {
  send_on(path, surface, direction, pdf);
  widen_diffusely(path);
}

SunAndSkyRays light_and_scatter(const RenderScene& scene, Path& path, const Surface& surface) {
  // Next-event estimation: draw a point on each kind of light. Lamps lie anywhere, so their shadow rays are
  // traced one by one.
  const SunAndSkyRays rays{towards_sun(scene, path, surface), towards_sky(scene, path, surface)};
  gather_lamps(scene, path, surface);

  // Continue.
  scatter(path, surface);
  return rays;
}

void trace_paths(const RenderScene& scene, int max_shaded_vertices, Path (&paths)[packet_size]) {
  trace_paths_with(scene, true, paths, [&](Path& path, const Hit& hit) {
    return shade_vertex(scene, max_shaded_vertices, path, hit);
  });
}

}  // namespace cps
