#include "renderer/geometry/alpha_filter.h"

#include <algorithm>
#include <cmath>

#include "renderer/math/sobol.h"

namespace cps {
namespace {

const Geometry& geometry_of(const RTCFilterFunctionNArguments* args) {
  return *static_cast<const Geometry*>(args->geometryUserPtr);
}

void filter_mask(const RTCFilterFunctionNArguments* args) {
  const Geometry& geometry = geometry_of(args);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    if (!geometry.passes_mask(triangle, RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i)))
      args->valid[i] = 0;
  }
}

void filter_blend_nearest(const RTCFilterFunctionNArguments* args) {
  const Geometry& geometry = geometry_of(args);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    const float alpha =
        geometry.alpha(triangle, RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i));
    const std::uint64_t surface =
        static_cast<std::uint64_t>(RTCHitN_geomID(args->hit, args->N, i)) << 32 | triangle;
    const std::uint64_t draw = mix64(mix64(surface + 1) ^ RTCRayN_id(args->ray, args->N, i));
    if (unit_float(static_cast<std::uint32_t>(draw)) >= alpha) args->valid[i] = 0;
  }
}

/// Shadow ray i keeps this share of its light, and goes on if any is left.
void let_pass(const RTCFilterFunctionNArguments* args, unsigned i, const Color& share) {
  auto* context = reinterpret_cast<ShadowContext*>(args->context);
  Color& left = context->transmittance[RTCRayN_id(args->ray, args->N, i)];
  left *= share;
  if ((left > 0.0f).any()) args->valid[i] = 0;
}

void filter_blend_shadow(const RTCFilterFunctionNArguments* args) {
  const Geometry& geometry = geometry_of(args);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    const float alpha =
        geometry.alpha(triangle, RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i));
    let_pass(args, i, std::max(0.0f, 1.0f - alpha) * Color::Ones());
  }
}

void filter_glass_shadow(const RTCFilterFunctionNArguments* args) {
  const Geometry& geometry = geometry_of(args);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    const float u = RTCHitN_u(args->hit, args->N, i), v = RTCHitN_v(args->hit, args->N, i);
    const Vec3 normal(RTCHitN_Ng_x(args->hit, args->N, i), RTCHitN_Ng_y(args->hit, args->N, i),
                      RTCHitN_Ng_z(args->hit, args->N, i));
    const Vec3 direction(RTCRayN_dir_x(args->ray, args->N, i), RTCRayN_dir_y(args->ray, args->N, i),
                         RTCRayN_dir_z(args->ray, args->N, i));
    const float cosine = std::abs(normal.dot(direction)) / (normal.norm() * direction.norm());
    const TextureFootprint at = geometry.full_detail(triangle, u, v);
    const Color base_color = geometry.base_color(triangle, u, v, at).head<3>();
    const Color through =
        thin_glass_transmittance(bsdf_parameters(*geometry.material, base_color, at), cosine);
    const float covered = geometry.coverage(triangle, u, v);
    let_pass(args, i, 1.0f - covered + covered * through);
  }
}

}  // namespace

ShadowContext::ShadowContext() {
  rtcInitIntersectContext(&embree);
  std::fill(std::begin(transmittance), std::end(transmittance), Color::Ones());
}

void set_alpha_filters(RTCGeometry embree, const Geometry& geometry) {
  const SurfaceMaterial& material = *geometry.material;
  const RTCFilterFunctionN nearest = material.alpha_mode == AlphaMode::mask    ? filter_mask
                                     : material.alpha_mode == AlphaMode::blend ? filter_blend_nearest
                                                                               : nullptr;
  const RTCFilterFunctionN shadow = material.transmits                        ? filter_glass_shadow
                                    : material.alpha_mode == AlphaMode::blend ? filter_blend_shadow
                                                                              : nearest;
  rtcSetGeometryUserData(embree, const_cast<Geometry*>(&geometry));
  if (nearest) rtcSetGeometryIntersectFilterFunction(embree, nearest);
  if (shadow) rtcSetGeometryOccludedFilterFunction(embree, shadow);
}

}  // namespace cps
