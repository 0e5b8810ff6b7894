#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <vector>

#include "renderer/geometry/packed_vertex.h"
#include "renderer/materials/material.h"

namespace cps {

/// Value at barycentric (u, v) of a triangle whose corners have values a, b, c.
template <class T>
T interpolate(const T& a, const T& b, const T& c, float u, float v) {
  return a * (1.0f - u - v) + b * u + c * v;
}

/// Texture coordinates of a triangle's corners in one uv set.
struct TriangleUv {
  Eigen::Vector2f a, b, c;

  Eigen::Vector2f at(float u, float v) const { return interpolate(a, b, c, u, v); }
  /// Of the parallelogram between ab and ac, in units of the uv set: twice the triangle's.
  float double_area() const {
    const Eigen::Vector2f ab = b - a, ac = c - a;
    return std::abs(ab.x() * ac.y() - ab.y() * ac.x());
  }
};

/// Triangles of one material as the tracer holds them: in world coordinates, or, if several placements share
/// them, in the mesh's own. Hits are given by triangle and barycentric (u, v).
struct Geometry {
  std::vector<PackedVertex> vertices;
  std::vector<Eigen::Vector3i> triangles;
  std::vector<Eigen::Vector2f> uv1;                     ///< empty or one per vertex
  std::vector<Eigen::Array<Eigen::half, 4, 1>> colors;  ///< empty or one per vertex
  const SurfaceMaterial* material = nullptr;
  bool viewer_only = false;  ///< an enclosure or an inside-out shell: light passes

  /// Set 0 or 1. Geometry without a set 1 has set 0 in both.
  TriangleUv corner_uv(std::uint32_t triangle, int uv_set) const;

  /// Base colour and its alpha, with texture and vertex colours.
  Eigen::Array4f base_color(std::uint32_t triangle, float u, float v, const TextureFootprint& at) const;

  /// Footprint of a point, for texture lookups in the full image.
  TextureFootprint full_detail(std::uint32_t triangle, float u, float v) const;

  /// Base colour's alpha in the full image.
  float alpha(std::uint32_t triangle, float u, float v) const;

  /// glTF's alpha test: whether alpha reaches the cutoff.
  bool passes_mask(std::uint32_t triangle, float u, float v) const;

  /// Share of the surface that is there, by its alpha mode: 1 where it is opaque.
  float coverage(std::uint32_t triangle, float u, float v) const;
};

/// One instance of a mesh in the world.
struct Placement {
  int geometry = 0;
  int instance = 0;       ///< of the scene
  bool shared = false;    ///< true: the transforms below apply; false: geometry is in world coordinates
  bool mirrored = false;  ///< by the transforms below: triangles wind the other way in the world
  bool rides = false;     ///< moves with the car (see put_car); implies `shared`
  Eigen::Affine3f world_from_mesh = Eigen::Affine3f::Identity();
  Eigen::Matrix3f normal_from_mesh =
      Eigen::Matrix3f::Identity();  ///< inverse transpose, so that mirrored fronts stay fronts
};

struct PlacedGeometry {
  std::vector<Geometry> geometries;
  std::vector<Placement> placements;
};

/// A triangle in the world.
struct WorldTriangle {
  const Geometry& geometry;
  const Placement& placement;
  Eigen::Vector3i corner;
  Vec3 positions[3];
  Vec3 normal;  ///< of the front face, by winding; twice the area long
};

WorldTriangle world_triangle(const PlacedGeometry& placed, std::uint32_t placement, std::uint32_t triangle);

/// Prefetches a triangle's corner indices into the cache; once they are there, its vertices.
inline void prefetch_corners(const PlacedGeometry& placed, std::uint32_t placement, std::uint32_t triangle) {
  __builtin_prefetch(&placed.geometries[placed.placements[placement].geometry].triangles[triangle]);
}
inline void prefetch_vertices(const PlacedGeometry& placed, std::uint32_t placement, std::uint32_t triangle) {
  const Geometry& geometry = placed.geometries[placed.placements[placement].geometry];
  for (const int corner : geometry.triangles[triangle]) __builtin_prefetch(&geometry.vertices[corner]);
}

/// Metres by which rounding may move a point on the triangle.
float rounding_of(const WorldTriangle& triangle);

}  // namespace cps
