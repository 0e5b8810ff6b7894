#include "renderer/surface.h"

#include <algorithm>
#include <cmath>

#include "renderer/fast_math.h"

namespace cps {
namespace {

/// The triangle of a hit in the world.
struct WorldTriangle {
  const Geometry& geometry;
  const Placement& placement;
  Eigen::Vector3i corner;
  Vec3 positions[3];
  Vec3 normal;  ///< of the front face, by winding; twice the area long in world units
};

WorldTriangle world_triangle(const PlacedGeometry& placed, const Hit& hit) {
  const Placement& placement = placed.placements[hit.placement];
  const Geometry& geometry = placed.geometries[placement.geometry];
  WorldTriangle t{geometry, placement, geometry.triangles[hit.triangle], {}, {}};
  for (int i = 0; i < 3; ++i) t.positions[i] = geometry.vertices[t.corner[i]].position;
  if (placement.shared) {
    for (Vec3& position : t.positions) position = placement.world_from_mesh * position;
  }
  t.normal = (t.positions[1] - t.positions[0]).cross(t.positions[2] - t.positions[0]);
  if (placement.shared && placement.mirrored) t.normal = -t.normal;
  return t;
}

Eigen::Vector2f uv_of(const Geometry& geometry, int uv_set, int vertex) {
  if (uv_set == 0) return geometry.vertices[vertex].uv;
  return geometry.uv1.empty() ? Eigen::Vector2f::Zero() : geometry.uv1[vertex];
}

/// Texture coordinates at the hit, and the ray's footprint in their units (ray cones: Akenine-Möller et al.
/// 2019): the cone's width, stretched by the cosine, times the square root of uv area over world area.
TextureFootprint texture_footprint(const WorldTriangle& t, const Hit& hit, float width, float cosine) {
  TextureFootprint footprint;
  const float world_area = t.normal.norm();
  const float world_width = width / std::max(cosine, 1e-3f);
  const int sets = t.geometry.uv1.empty() ? 1 : 2;
  for (int set = 0; set < sets; ++set) {
    const Eigen::Vector2f a = uv_of(t.geometry, set, t.corner.x()), b = uv_of(t.geometry, set, t.corner.y()),
                          c = uv_of(t.geometry, set, t.corner.z());
    footprint.uv[set] = interpolate(a, b, c, hit.u, hit.v);
    const Eigen::Vector2f ab = b - a, ac = c - a;
    const float uv_area = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
    const float squared = world_width * world_width * uv_area / world_area;
    footprint.log2_width[set] = 0.5f * log2_of(std::clamp(squared, 1e-30f, 1e30f));
  }
  if (sets == 1) {
    footprint.uv[1] = footprint.uv[0];
    footprint.log2_width[1] = footprint.log2_width[0];
  }
  return footprint;
}

/// What a normal map does to the interpolated normal, in the world.
Vec3 mapped_normal(const WorldTriangle& t, const Hit& hit, const Vec3& normal,
                   const TextureFootprint& footprint) {
  const SurfaceMaterial& material = *t.geometry.material;
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

  const Eigen::Array4f texel = material.normal_texture.sample(footprint);
  const Vec3 n = 2.0f * texel.head<3>().matrix() - Vec3::Ones();
  return (material.normal_scale * (n.x() * tangent + n.y() * bitangent) + std::max(n.z(), 0.05f) * normal)
      .normalized();
}

/// Bends a shading normal so that the mirror image of `wo` leaves the true surface: without it a bump that
/// faces away from the viewer, or reflects into the surface, turns black (as Keller et al. 2017, "The Iray
/// light transport simulation and rendering system", section A.3).
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
  return world_triangle(placed, hit).normal.dot(ray.direction) > 0.0f;
}

Surface make_surface(const PlacedGeometry& placed, const Ray& ray, const Hit& hit, float footprint_width,
                     float least_roughness) {
  const WorldTriangle t = world_triangle(placed, hit);
  const Geometry& geometry = t.geometry;
  const SurfaceMaterial& material = *geometry.material;
  const Vec3 wo = -ray.direction;

  Surface surface;
  surface.position = interpolate(t.positions[0], t.positions[1], t.positions[2], hit.u, hit.v);
  // Coordinates are exact to 2^-24 of the largest one: a few roundings happen in transforms, interpolation
  // and Embree.
  float largest = 0.0f;
  for (const Vec3& position : t.positions) largest = std::max(largest, position.cwiseAbs().maxCoeff());
  surface.clearance = 1e-6f * largest + 1e-6f;

  const float world_area = t.normal.norm();
  const Vec3 front = world_area > 0.0f ? Vec3(t.normal / world_area) : wo;
  const bool is_front = front.dot(wo) >= 0.0f;
  surface.geometric_normal = is_front ? front : Vec3(-front);

  const TextureFootprint footprint = texture_footprint(t, hit, footprint_width, std::abs(front.dot(wo)));
  Vec3 normal = interpolate(unpack_direction(geometry.vertices[t.corner.x()].normal),
                            unpack_direction(geometry.vertices[t.corner.y()].normal),
                            unpack_direction(geometry.vertices[t.corner.z()].normal), hit.u, hit.v);
  if (t.placement.shared) normal = t.placement.normal_from_mesh * normal;
  const float length = normal.norm();
  normal = length > 1e-6f ? Vec3(normal / length) : front;
  const bool faces_away = normal.dot(surface.geometric_normal) < 0.0f;
  if (material.normal_texture.texture) normal = mapped_normal(t, hit, normal, footprint);
  if (faces_away) normal = -normal;
  normal = bent_towards_viewer(normal, surface.geometric_normal, wo);
  surface.shading = frame_around(normal);
  surface.wo = surface.shading.to_local(wo);
  surface.wo.z() = std::max(surface.wo.z(), 1e-4f);

  Eigen::Array4f base_color = material.base_color * material.base_color_texture.sample(footprint);
  if (!geometry.colors.empty()) {
    const auto color_of = [&](int i) -> Eigen::Array4f { return geometry.colors[i].cast<float>(); };
    base_color *=
        interpolate(color_of(t.corner.x()), color_of(t.corner.y()), color_of(t.corner.z()), hit.u, hit.v);
  }
  float metallic = material.metallic, roughness = material.roughness;
  if (material.metallic_roughness_texture.texture) {
    const Eigen::Array4f texel = material.metallic_roughness_texture.sample(footprint);
    roughness *= texel.y();
    metallic *= texel.z();
  }
  // What reflects more than arrives would brighten with every bounce.
  surface.bsdf = make_bsdf(base_color.head<3>().min(1.0f), metallic, std::max(roughness, least_roughness),
                           surface.wo.z());

  surface.emission = Color::Zero();
  if (material.emits && (is_front || material.double_sided)) {
    surface.emission = material.emissive * material.emissive_texture.sample(footprint).head<3>();
  }
  return surface;
}

}  // namespace cps
