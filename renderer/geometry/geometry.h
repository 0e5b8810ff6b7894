#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "renderer/geometry/packed_vertex.h"
#include "renderer/materials/material.h"
#include "scenes/scene.h"

namespace cps {

/// Triangles of one material as the tracer holds them: in world coordinates, or, if several placements share
/// them, in the mesh's own.
struct Geometry {
  std::vector<PackedVertex> vertices;
  std::vector<Eigen::Vector3i> triangles;
  std::vector<Eigen::Vector2f> uv1;                     ///< empty or one per vertex
  std::vector<Eigen::Array<Eigen::half, 4, 1>> colors;  ///< empty or one per vertex
  const SurfaceMaterial* material = nullptr;
  bool viewer_only = false;  ///< an inside-out shell: light passes, see inside_out.h

  /// Base colour with texture and vertex colours, and its alpha, where barycentric (u, v) hits a triangle.
  Eigen::Array4f base_color(std::uint32_t triangle, float u, float v, const TextureFootprint& at) const;

  /// The texture coordinates there, for lookups on the full image.
  TextureFootprint in_full_detail(std::uint32_t triangle, float u, float v) const;

  /// Base colour's alpha where barycentric (u, v) hits a triangle, on the full image.
  float alpha(std::uint32_t triangle, float u, float v) const;
};

/// Geometry put into the world.
struct Placement {
  int geometry = 0;
  int instance = 0;       ///< of the scene
  bool shared = false;    ///< the transforms below apply; otherwise the geometry lies in world coordinates
  bool mirrored = false;  ///< by the transforms below: triangles wind the other way in the world
  bool rides = false;     ///< with the car, and is shared: see put_car
  Eigen::Affine3f world_from_mesh = Eigen::Affine3f::Identity();
  Eigen::Matrix3f normal_from_mesh =
      Eigen::Matrix3f::Identity();  ///< inverse transpose: a mirror keeps fronts in front
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

/// Ask the cache for a triangle's corners, and, once they have come, for its vertices.
inline void prefetch_corners(const PlacedGeometry& placed, std::uint32_t placement, std::uint32_t triangle) {
  __builtin_prefetch(&placed.geometries[placed.placements[placement].geometry].triangles[triangle]);
}
inline void prefetch_vertices(const PlacedGeometry& placed, std::uint32_t placement, std::uint32_t triangle) {
  const Geometry& geometry = placed.geometries[placed.placements[placement].geometry];
  for (const int corner : geometry.triangles[triangle]) __builtin_prefetch(&geometry.vertices[corner]);
}

/// Metres by which a point on it may be off through rounding.
float rounding_of(const WorldTriangle& triangle);

/// Whether placements of this mesh share one copy: below a size, copies in world coordinates trace faster
/// than instances.
bool is_shared(const Mesh& mesh, std::size_t placements);

/// Flattens meshes that are placed once, or are so small that copies trace faster than instances, into world
/// coordinates; shares the others. Throws std::runtime_error where an index or a number in the scene is off.
PlacedGeometry place_geometry(const Scene& scene, const Materials& materials);

/// Value at barycentric (u, v) of a triangle whose corners have values a, b, c.
template <class T>
T interpolate(const T& a, const T& b, const T& c, float u, float v) {
  return a * (1.0f - u - v) + b * u + c * v;
}

}  // namespace cps
