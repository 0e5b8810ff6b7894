#include "scenes/gltf/geometry/normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

namespace cps::gltf {
namespace {

using Eigen::Vector3f;
using Eigen::Vector3i;

/// The triangle's unit normal times twice its area.
Vector3f area_normal(const Mesh& mesh, const Vector3i& triangle) {
  const Vector3f& a = mesh.positions[triangle[0]];
  return (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a);
}

/// The unit vector along `v`, +y for a zero vector. Scales first, so that the normals of tiny triangles do
/// not underflow.
Vector3f direction_or_up(const Vector3f& v) {
  const Vector3f scaled = v / std::max(v.cwiseAbs().maxCoeff(), 1e-38f);
  const float length = scaled.norm();
  return length > 0.5f ? Vector3f(scaled / length) : Vector3f::UnitY();
}

template <class T>
void unshare(std::vector<T>& values, const std::vector<Vector3i>& triangles) {
  if (values.empty()) return;
  std::vector<T> per_corner;
  per_corner.reserve(triangles.size() * 3);
  for (const Vector3i& triangle : triangles)
    for (int c = 0; c < 3; ++c) per_corner.push_back(values[triangle[c]]);
  values = std::move(per_corner);
}

}  // namespace

void make_flat_normals(Mesh& mesh) {
  mesh.tangents.clear();
  unshare(mesh.positions, mesh.triangles);
  unshare(mesh.uv0, mesh.triangles);
  unshare(mesh.uv1, mesh.triangles);
  unshare(mesh.colors, mesh.triangles);
  mesh.normals.clear();
  mesh.normals.reserve(mesh.positions.size());
  int next = 0;
  for (Vector3i& triangle : mesh.triangles) {
    triangle = {next, next + 1, next + 2};
    next += 3;
    mesh.normals.insert(mesh.normals.end(), 3, direction_or_up(area_normal(mesh, triangle)));
  }
}

std::size_t repair_normals(Mesh& mesh) {
  std::vector<std::uint8_t> is_broken(mesh.normals.size(), 0);
  std::size_t broken = 0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const float length = mesh.normals[i].norm();
    is_broken[i] = !(length > 1e-12f && length < 1e12f);
    mesh.normals[i] = is_broken[i] ? Vector3f::Zero() : Vector3f(mesh.normals[i] / length);
    broken += is_broken[i];
  }
  if (broken == 0) return 0;
  for (const Vector3i& triangle : mesh.triangles)
    for (const int vertex : triangle)
      if (is_broken[vertex]) mesh.normals[vertex] += area_normal(mesh, triangle);
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    if (is_broken[i]) mesh.normals[i] = direction_or_up(mesh.normals[i]);
  return broken;
}

}  // namespace cps::gltf
