#include "renderer/alpha_filter.h"

#include "renderer/sobol.h"

namespace cps {
namespace {

const Geometry& geometry_of(const RTCFilterFunctionNArguments* args) {
  return *static_cast<const Geometry*>(args->geometryUserPtr);
}

/// glTF's alpha test. Where vertex colours take part, the mask of the texture alone does not decide.
bool passes_mask(const Geometry& geometry, unsigned triangle, float u, float v) {
  const SurfaceMaterial& material = *geometry.material;
  if (!material.mask.texture || !geometry.colors.empty())
    return geometry.alpha(triangle, u, v) >= material.alpha_cutoff;
  const Eigen::Vector3i& corner = geometry.triangles[triangle];
  const TextureLookup& lookup = material.base_color_texture;
  const auto uv_of = [&](int i) { return lookup.uv_set == 0 ? geometry.vertices[i].uv : geometry.uv1[i]; };
  return material.mask.passes(
      lookup.coordinates(interpolate(uv_of(corner.x()), uv_of(corner.y()), uv_of(corner.z()), u, v)));
}

void filter_mask(const RTCFilterFunctionNArguments* args) {
  const Geometry& geometry = geometry_of(args);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    if (!passes_mask(geometry, triangle, RTCHitN_u(args->hit, args->N, i),
                     RTCHitN_v(args->hit, args->N, i))) {
      args->valid[i] = 0;
    }
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

void filter_blend_shadow(const RTCFilterFunctionNArguments* args) {
  const Geometry& geometry = geometry_of(args);
  auto* context = reinterpret_cast<ShadowContext*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    const float alpha =
        geometry.alpha(triangle, RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i));
    float& left = context->transmittance[RTCRayN_id(args->ray, args->N, i)];
    left *= std::max(0.0f, 1.0f - alpha);
    if (left > 0.0f) args->valid[i] = 0;
  }
}

}  // namespace

void init_shadow_context(ShadowContext& context) {
  rtcInitIntersectContext(&context.embree);
  std::fill(std::begin(context.transmittance), std::end(context.transmittance), 1.0f);
}

void set_alpha_filters(RTCGeometry embree, const Geometry& geometry) {
  rtcSetGeometryUserData(embree, const_cast<Geometry*>(&geometry));
  const bool mask = geometry.material->alpha_mode == AlphaMode::mask;
  rtcSetGeometryIntersectFilterFunction(embree, mask ? filter_mask : filter_blend_nearest);
  rtcSetGeometryOccludedFilterFunction(embree, mask ? filter_mask : filter_blend_shadow);
}

}  // namespace cps
