#include "renderer/paths/surface.h"

#include <algorithm>
#include <cmath>

#include "renderer/geometry/texture_footprint.h"

namespace cps {
namespace {

Vec3 interpolated_normal(const WorldTriangle& t, const Hit& hit) {
  const auto packed = [&](int corner) { return t.geometry.vertices[corner].normal; };
  const std::uint32_t a = packed(t.corner.x()), b = packed(t.corner.y()), c = packed(t.corner.z());
  if (a == b && a == c) return unpack_direction(a);  // flat: most walls and roads
  return interpolate(unpack_direction(a), unpack_direction(b), unpack_direction(c), hit.u, hit.v);
}

/// The interpolated normal, in the world, changed by a normal map.
Vec3 mapped_normal(const WorldTriangle& t, const Hit& hit, const Vec3& normal, const TextureLookup& map,
                   float scale, const TextureFootprint& footprint) {
  const auto& vertices = t.geometry.vertices;
  const float sign = vertices[t.corner.x()].bitangent_sign;
  if (sign == 0.0f) return normal;
  Vec3 tangent = interpolate(unpack_direction(vertices[t.corner.x()].tangent),
                             unpack_direction(vertices[t.corner.y()].tangent),
                             unpack_direction(vertices[t.corner.z()].tangent), hit.u, hit.v);
  if (t.placement.shared) tangent = t.placement.world_from_mesh.linear() * tangent;
  tangent -= normal * normal.dot(tangent);
  const float length = tangent.norm();
  if (length < 1e-6f) return normal;
  tangent /= length;
  const Vec3 bitangent = normal.cross(tangent) * (t.placement.mirrored ? -sign : sign);

  const Eigen::Array4f texel = map.sample(footprint);
  const Vec3 n = 2.0f * texel.head<3>().matrix() - Vec3::Ones();
  return (scale * (n.x() * tangent + n.y() * bitangent) + std::max(n.z(), 0.05f) * normal).normalized();
}

/// Bends a shading normal so that the mirror image of `wo` leaves the true surface. Otherwise bumps that face
/// away from the viewer, or reflect into the surface, turn black (Keller et al. 2017, "The Iray light
/// transport simulation and rendering system", section A.3).
Vec3 bent_towards_viewer(const Vec3& normal, const Vec3& geometric_normal, const Vec3& wo) {
  const Vec3 reflected = 2.0f * normal.dot(wo) * normal - wo;
  const float lowest = std::min(0.01f, 0.9f * geometric_normal.dot(wo));
  const float below = lowest - geometric_normal.dot(reflected);
  if (below <= 0.0f) return normal;
  return (wo + (reflected + below * geometric_normal).normalized()).normalized();
}

}  // namespace

bool is_culled(const PlacedGeometry& placed, const Ray& ray, const Hit& hit) {
  const Placement& placement = placed.placements[hit.placement];
  if (placed.geometries[placement.geometry].material->double_sided) return false;
  return world_triangle(placed, hit.placement, hit.triangle).normal.dot(ray.direction) > 0.0f;
}

Surface make_surface(const PlacedGeometry& placed, const Ray& ray, const Hit& hit, float footprint_width,
                     float min_roughness) {
  const WorldTriangle t = world_triangle(placed, hit.placement, hit.triangle);
  const Geometry& geometry = t.geometry;
  const SurfaceMaterial& material = *geometry.material;
  const Vec3 wo = -ray.direction;

  Surface surface;
  surface.position = interpolate(t.positions[0], t.positions[1], t.positions[2], hit.u, hit.v);
  surface.clearance = rounding_of(t);
  surface.meets_car = ray.meets_car;

  const float world_area = t.normal.norm();
  const Vec3 front = world_area > 0.0f ? Vec3(t.normal / world_area) : wo;
  const bool is_front = front.dot(wo) >= 0.0f;
  surface.geometric_normal = is_front ? front : Vec3(-front);

  const TextureFootprint footprint = texture_footprint(t, hit, ray, footprint_width, std::abs(front.dot(wo)));
  Vec3 normal = interpolated_normal(t, hit);
  if (t.placement.shared) normal = t.placement.normal_from_mesh * normal;
  const float length = normal.norm();
  normal = length > 1e-6f ? Vec3(normal / length) : front;
  const bool faces_away = normal.dot(surface.geometric_normal) < 0.0f;
  const Vec3 smooth_normal = normal;
  const auto facing_viewer = [&](const Vec3& n) {
    return bent_towards_viewer(faces_away ? Vec3(-n) : n, surface.geometric_normal, wo);
  };
  if (material.normal_texture.texture)
    normal = mapped_normal(t, hit, normal, material.normal_texture, material.normal_scale, footprint);
  surface.shading = frame_around(facing_viewer(normal));
  surface.wo = surface.shading.to_local(wo);
  surface.wo.z() = std::max(surface.wo.z(), 1e-4f);

  const Color base_color = geometry.base_color(hit.triangle, hit.u, hit.v, footprint).head<3>();
  surface.base_color = base_color;
  const bool shows = is_front || material.double_sided;
  surface.emission = Color::Zero();
  surface.scatters = !material.unlit;
  if (!surface.scatters) {
    if (shows) surface.emission = material.unlit_radiance * base_color;
    return surface;
  }
  if (material.emits && shows)
    surface.emission = material.emissive * material.emissive_texture.sample(footprint).head<3>();

  BsdfParameters parameters = bsdf_parameters(material, base_color, footprint);
  if (material.transmits) parameters.straight = thin_glass_transmittance(parameters, std::abs(front.dot(wo)));
  parameters.roughness = std::max(parameters.roughness, min_roughness);
  if (parameters.clearcoat > 0.0f) {
    parameters.clearcoat_roughness = std::max(parameters.clearcoat_roughness, min_roughness);
    const Vec3 coat_normal = material.clearcoat_normal_texture.texture
                                 ? mapped_normal(t, hit, smooth_normal, material.clearcoat_normal_texture,
                                                 material.clearcoat_normal_scale, footprint)
                                 : smooth_normal;
    parameters.clearcoat_normal = surface.shading.to_local(facing_viewer(coat_normal));
  }
  surface.bsdf = make_bsdf(parameters, surface.wo);
  return surface;
}

}  // namespace cps
