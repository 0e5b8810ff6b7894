#include "scenes/gltf/vertex_frames.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace cps::gltf {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector3i;

/// Twice the area times the unit normal.
Vector3f area_normal(const Mesh& mesh, const Vector3i& triangle) {
  const Vector3f& a = mesh.positions[triangle[0]];
  return (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a);
}

/// Sizes do not matter here, so tiny triangles must not underflow; those without a direction become +y.
Vector3f direction_or_up(const Vector3f& v) {
  const Vector3f scaled = v / std::max(v.cwiseAbs().maxCoeff(), 1e-38f);
  const float length = scaled.norm();
  return length > 0.5f ? Vector3f(scaled / length) : Vector3f::UnitY();
}

float corner_angle(const Mesh& mesh, const Vector3i& triangle, int corner) {
  const Vector3f& at = mesh.positions[triangle[corner]];
  const Vector3f a = mesh.positions[triangle[(corner + 1) % 3]] - at;
  const Vector3f b = mesh.positions[triangle[(corner + 2) % 3]] - at;
  return std::atan2(a.cross(b).norm(), a.dot(b));
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

template <class T>
void repeat(std::vector<T>& values, int index) {
  if (!values.empty()) values.push_back(T(values[index]));
}

/// A triangle's ∂position/∂u, and whether its uv are mirrored: v runs down in glTF, so a front face whose u
/// runs right and v down is the unmirrored one.
struct UvFrame {
  Vector3f along_u = Vector3f::Zero();
  bool mirrored = false;
};

UvFrame uv_frame(const Mesh& mesh, const std::vector<Vector2f>& uv, const Vector3i& triangle) {
  const Vector3f e1 = mesh.positions[triangle[1]] - mesh.positions[triangle[0]];
  const Vector3f e2 = mesh.positions[triangle[2]] - mesh.positions[triangle[0]];
  const Vector2f d1 = uv[triangle[1]] - uv[triangle[0]], d2 = uv[triangle[2]] - uv[triangle[0]];
  const float determinant = d1.x() * d2.y() - d1.y() * d2.x();
  if (determinant == 0 || !std::isfinite(determinant)) return {};
  const float sign = determinant > 0 ? 1.0f : -1.0f;
  return {sign * (e1 * d2.y() - e2 * d1.y()), determinant > 0};
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

void make_tangents(Mesh& mesh, const TextureSlot& slot) {
  std::vector<Vector2f> uv = slot.uv_set == 1 ? mesh.uv1 : mesh.uv0;
  for (Vector2f& coordinate : uv) coordinate = slot.uv_transform * coordinate;

  // Sums for unmirrored [0] and mirrored [1] triangles at each vertex.
  const std::size_t vertices = mesh.positions.size();
  std::array<std::vector<Vector3f>, 2> sums;
  sums.fill(std::vector<Vector3f>(vertices, Vector3f::Zero()));
  std::vector<UvFrame> frames;
  frames.reserve(mesh.triangles.size());
  for (const Vector3i& triangle : mesh.triangles) {
    frames.push_back(uv_frame(mesh, uv, triangle));
    for (int c = 0; c < 3; ++c) {
      const Vector3f& normal = mesh.normals[triangle[c]];
      const Vector3f& along_u = frames.back().along_u;
      const Vector3f tangent = (along_u - normal * normal.dot(along_u)).stableNormalized();
      if (tangent.allFinite())
        sums[frames.back().mirrored][triangle[c]] += corner_angle(mesh, triangle, c) * tangent;
    }
  }

  const auto tangent_at = [&](std::size_t vertex, bool mirrored) {
    Vector3f tangent = sums[mirrored][vertex].stableNormalized();
    if (!(tangent.norm() > 0.5f)) tangent = mesh.normals[vertex].unitOrthogonal();
    return Eigen::Vector4f(tangent.x(), tangent.y(), tangent.z(), mirrored ? -1.0f : 1.0f);
  };
  std::vector<int> mirrored_twin(vertices, -1);
  std::vector<std::uint8_t> used_unmirrored(vertices, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!frames[t].mirrored)
      for (const int vertex : mesh.triangles[t]) used_unmirrored[vertex] = 1;
  mesh.tangents.resize(vertices);
  for (std::size_t i = 0; i < vertices; ++i) mesh.tangents[i] = tangent_at(i, !used_unmirrored[i]);

  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!frames[t].mirrored) continue;
    for (int& vertex : mesh.triangles[t]) {
      if (!used_unmirrored[vertex]) continue;
      if (mirrored_twin[vertex] == -1) {
        mirrored_twin[vertex] = static_cast<int>(mesh.positions.size());
        mesh.tangents.push_back(tangent_at(vertex, true));
        repeat(mesh.positions, vertex);
        repeat(mesh.normals, vertex);
        repeat(mesh.uv0, vertex);
        repeat(mesh.uv1, vertex);
        repeat(mesh.colors, vertex);
      }
      vertex = mirrored_twin[vertex];
    }
  }
}

bool normalize_tangents(Mesh& mesh) {
  for (Eigen::Vector4f& tangent : mesh.tangents) {
    const float length = tangent.head<3>().norm(), handedness = std::abs(tangent.w());
    if (!(length > 0.5f && length < 2 && handedness > 0.5f && handedness < 2)) return false;
    tangent.head<3>() /= length;
    tangent.w() = tangent.w() > 0 ? 1.0f : -1.0f;
  }
  return true;
}

}  // namespace cps::gltf
