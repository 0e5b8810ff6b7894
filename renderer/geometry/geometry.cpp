#include "renderer/geometry/geometry.h"

#include <algorithm>

namespace cps {

Eigen::Array4f Geometry::base_color(std::uint32_t triangle, float u, float v,
                                    const TextureFootprint& at) const {
  Eigen::Array4f color = material->base_color * material->base_color_texture.sample(at);
  if (!colors.empty()) {
    const Eigen::Vector3i& corner = triangles[triangle];
    const auto color_of = [&](int i) -> Eigen::Array4f { return colors[i].cast<float>(); };
    color *= interpolate(color_of(corner.x()), color_of(corner.y()), color_of(corner.z()), u, v);
  }
  return color;
}

TriangleUv Geometry::corner_uv(std::uint32_t triangle, int uv_set) const {
  const Eigen::Vector3i& corner = triangles[triangle];
  if (uv_set == 0 || uv1.empty())
    return {vertices[corner.x()].uv, vertices[corner.y()].uv, vertices[corner.z()].uv};
  return {uv1[corner.x()], uv1[corner.y()], uv1[corner.z()]};
}

TextureFootprint Geometry::full_detail(std::uint32_t triangle, float u, float v) const {
  constexpr float log2_of_a_point = -100.0f;
  return {{corner_uv(triangle, 0).at(u, v), corner_uv(triangle, 1).at(u, v)},
          {log2_of_a_point, log2_of_a_point}};
}

float Geometry::alpha(std::uint32_t triangle, float u, float v) const {
  const TextureLookup& lookup = material->base_color_texture;
  float alpha = material->base_color.w();
  if (lookup.texture) {
    const Eigen::Vector2f uv = corner_uv(triangle, lookup.uv_set).at(u, v);
    alpha *= lookup.texture->sample(lookup.coordinates(uv), 0.0f).w();
  }
  if (!colors.empty()) {
    const Eigen::Vector3i& corner = triangles[triangle];
    const auto alpha_of = [&](int i) { return static_cast<float>(colors[i].w()); };
    alpha *= interpolate(alpha_of(corner.x()), alpha_of(corner.y()), alpha_of(corner.z()), u, v);
  }
  return alpha;
}

bool Geometry::passes_mask(std::uint32_t triangle, float u, float v) const {
  // The mask knows the texture's alpha alone: vertex colours need the full product.
  if (!material->mask.texture || !colors.empty()) return alpha(triangle, u, v) >= material->alpha_cutoff;
  const TextureLookup& lookup = material->base_color_texture;
  return material->mask.passes(lookup.coordinates(corner_uv(triangle, lookup.uv_set).at(u, v)));
}

float Geometry::coverage(std::uint32_t triangle, float u, float v) const {
  switch (material->alpha_mode) {
    case AlphaMode::opaque:
      return 1.0f;
    case AlphaMode::mask:
      return passes_mask(triangle, u, v) ? 1.0f : 0.0f;
    case AlphaMode::blend:
      break;
  }
  return std::clamp(alpha(triangle, u, v), 0.0f, 1.0f);
}

WorldTriangle world_triangle(const PlacedGeometry& placed, std::uint32_t placement, std::uint32_t triangle) {
  const Placement& place = placed.placements[placement];
  const Geometry& geometry = placed.geometries[place.geometry];
  WorldTriangle t{geometry, place, geometry.triangles[triangle], {}, {}};
  for (int i = 0; i < 3; ++i) t.positions[i] = geometry.vertices[t.corner[i]].position;
  if (place.shared) {
    for (Vec3& position : t.positions) position = place.world_from_mesh * position;
  }
  t.normal = (t.positions[1] - t.positions[0]).cross(t.positions[2] - t.positions[0]);
  if (place.shared && place.mirrored) t.normal = -t.normal;
  return t;
}

float rounding_of(const WorldTriangle& triangle) {
  // Coordinates are exact to 2^-24 of the largest one: a few roundings happen in transforms, interpolation
  // and Embree.
  float largest = 0.0f;
  for (const Vec3& position : triangle.positions) largest = std::max(largest, position.cwiseAbs().maxCoeff());
  return 1e-6f * largest + 1e-6f;
}

}  // namespace cps
