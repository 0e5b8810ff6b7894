#include "renderer/paths/direct_light.h"

#include <cmath>

namespace cps {
namespace {

/// Power heuristic (Veach 1997, β = 2): weight of a direction drawn with density `pdf`, which another
/// strategy draws with density `other`.
float mis_weight(float pdf, float other) {
  if (std::isinf(pdf)) return 1.0f;
  const float ratio = other / pdf;
  return 1.0f / (1.0f + ratio * ratio);
}

/// Light that a vertex gets from `direction`, drawn with density `pdf`, if nothing stands between.
/// `base_counts`: also for a diffuse base that the path does not draw.
ShadowRay shadow_ray(const Path& path, const Surface& surface, const Vec3& direction, float pdf,
                     const Color& light_over_pdf, bool base_counts = true) {
  ShadowRay shadow;
  if (surface.geometric_normal.dot(direction) <= 0.0f) return shadow;
  const BsdfValue bsdf = evaluate_bsdf(surface.bsdf, surface.wo, surface.shading.to_local(direction));
  const bool adds_base = base_counts && !surface.bsdf.draws_base;
  if (bsdf.pdf <= 0.0f && !adds_base) return shadow;
  shadow.ray = surface.leave(direction);
  shadow.contribution = path.throughput * bsdf.f_cos * light_over_pdf * mis_weight(pdf, bsdf.pdf);
  if (adds_base) shadow.contribution += path.throughput * bsdf.base_f_cos * light_over_pdf;
  shadow.wanted = (shadow.contribution > 0.0f).any();
  return shadow;
}

ShadowRay towards_lamp(const Path& path, const Surface& surface, const LampSample& sample) {
  if (!(sample.pdf > 0.0f)) return {};
  ShadowRay shadow = shadow_ray(path, surface, sample.direction, sample.pdf, sample.light_over_pdf);
  shadow.ray.t_far = sample.distance - surface.clearance;
  shadow.wanted = shadow.wanted && shadow.ray.t_far > 0.0f;
  return shadow;
}

}  // namespace

Color light_from_beyond(const RenderScene& scene, const Path& path) {
  const Vec3& direction = path.ray.direction;
  Color light = scene.sky.radiance(direction) * mis_weight(path.pdf, scene.sky.distribution.pdf(direction));
  if (!path.skips_sun_and_lamps && scene.sun.covers(direction))
    light += scene.sun.radiance * mis_weight(path.pdf, scene.sun.pdf);
  return light;
}

Color light_from_lamp(const RenderScene& scene, const Path& path, const Hit& hit, const Surface& surface) {
  if ((surface.emission == 0.0f).all()) return Color::Zero();
  const float pdf = std::isinf(path.pdf)
                        ? 0.0f
                        : scene.lamps.pdf(scene.placed, path.vertex_position, path.vertex_normal,
                                          hit.placement, hit.triangle, surface.position);
  if (path.skips_sun_and_lamps && pdf > 0.0f) return Color::Zero();
  return surface.emission * mis_weight(path.pdf, pdf);
}

ShadowRay towards_sun(const RenderScene& scene, const Path& path, const Surface& surface) {
  const Sun& sun = scene.sun;
  if (!sun.shines() || surface.geometric_normal.dot(sun.direction) + std::sqrt(sun.chord2) <= 0.0f) return {};
  return shadow_ray(path, surface, sun.sample(path.pair(pair_sun)), sun.pdf, sun.radiance / sun.pdf);
}

ShadowRay towards_sky(const RenderScene& scene, const Path& path, const Surface& surface) {
  if (scene.sky.distribution.empty()) return {};
  // Where the base has its light already, the rest is worth a ray only now and then.
  float share = 1.0f;
  if (!surface.bsdf.draws_base) {
    share = 1.0f - surface.bsdf.diffuse_probability;
    if (path.pair(pair_lobe).y() >= share) return {};
  }
  const DirectionSample sample = scene.sky.distribution.sample(path.pair(pair_sky));
  if (surface.geometric_normal.dot(sample.direction) <= 0.0f) return {};
  return shadow_ray(path, surface, sample.direction, sample.pdf,
                    scene.sky.radiance(sample.direction) / (share * sample.pdf), false);
}

void gather_lamps(const RenderScene& scene, Path& path, const Surface& surface) {
  const auto gather = [&](const LampSample& sample) {
    const ShadowRay shadow = towards_lamp(path, surface, sample);
    if (!shadow.wanted) return;
    ++path.rays;
    const Color light = scene.bvh.transmittance(shadow.ray) * shadow.contribution;
    path.radiance += light;
    if (path.record) path.record->vertices.back().lamps += light;
  };
  const Eigen::Vector2f which = path.pair(pair_which_lamp);
  if (!scene.lamps.tree.empty()) {
    gather(scene.lamps.sample(scene.placed, surface.position, surface.geometric_normal, which.x(),
                              path.pair(pair_lamp)));
  }
  if (!scene.lamps.directions.empty()) gather(scene.lamps.sample_direction(which.y()));
}

void gather_all(const RenderScene& scene, const ShadowRay (&shadows)[packet_size], bool coherent,
                Color VertexRecord::*kind, Path (&paths)[packet_size]) {
  Color transmittance[packet_size];
  if (coherent) {
    Ray lanes[packet_size];
    bool active[packet_size];
    for (int i = 0; i < packet_size; ++i) lanes[i] = shadows[i].ray, active[i] = shadows[i].wanted;
    scene.bvh.transmittance_coherent(lanes, active, transmittance);
  }
  for (int i = 0; i < packet_size; ++i) {
    if (!shadows[i].wanted) continue;
    ++paths[i].rays;
    if (!coherent) transmittance[i] = scene.bvh.transmittance(shadows[i].ray);
    const Color light = transmittance[i] * shadows[i].contribution;
    paths[i].radiance += light;
    if (paths[i].record) paths[i].record->vertices.back().*kind += light;
  }
}

}  // namespace cps
