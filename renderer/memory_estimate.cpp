#include "renderer/memory_estimate.h"

#include <algorithm>

#include "renderer/geometry/place_geometry.h"

namespace cps {
namespace {

/// Peak during Embree 3.13's build at medium quality. Measured: 99 and 93 on grids of 2 and 10 million
/// triangles, of which 67 and 60 remain after the build; 71 remain in a city, whose leaves are less full.
constexpr std::size_t bvh_bytes_per_triangle = 120;

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

/// Of a mesh as imported.
std::size_t scene_bytes(const Mesh& mesh) {
  return bytes_of(mesh.positions) + bytes_of(mesh.normals) + bytes_of(mesh.uv0) + bytes_of(mesh.uv1) +
         bytes_of(mesh.tangents) + bytes_of(mesh.colors) + bytes_of(mesh.triangles);
}

/// Of a mesh as the tracer stores it.
std::size_t traced_bytes(const Mesh& mesh) {
  return mesh.positions.size() * sizeof(PackedVertex) + bytes_of(mesh.uv1) +
         mesh.colors.size() * sizeof(Eigen::Array<Eigen::half, 4, 1>) + bytes_of(mesh.triangles) +
         mesh.triangles.size() * bvh_bytes_per_triangle;
}

}  // namespace

std::size_t estimated_bytes(const Scene& scene) {
  std::vector<std::size_t> copies(scene.meshes.size(), 0);
  for (const Instance& instance : scene.instances) ++copies[instance.mesh];
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    bytes += scene_bytes(mesh) + traced_bytes(mesh) * (is_shared(mesh, copies[i]) ? 1 : copies[i]);
  }
  bytes += bytes_of(scene.instances) + scene.instances.size() * (sizeof(Placement) + 512);
  // The scene keeps its texels; a mip pyramid is a third larger; while one is built its texels are floats.
  std::size_t largest = 0;
  for (const Texture& texture : scene.textures) {
    bytes += texture.rgba.size() + texture.rgba.size() * 4 / 3;
    largest = std::max(largest, texture.rgba.size());
  }
  return bytes + 6 * largest;
}

}  // namespace cps
