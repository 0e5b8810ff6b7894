#include "scenes/gltf/geometry/tangents.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace cps::gltf {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector3i;

Vector3f in_plane(const Vector3f& v, const Vector3f& normal) {
  return (v - normal * normal.dot(v)).stableNormalized();
}

/// The angle of a triangle's corner, projected along the vertex normal.
float corner_angle(const Mesh& mesh, const Vector3i& triangle, int corner) {
  const Vector3f& at = mesh.positions[triangle[corner]];
  const Vector3f& normal = mesh.normals[triangle[corner]];
  const Vector3f a = in_plane(mesh.positions[triangle[(corner + 1) % 3]] - at, normal);
  const Vector3f b = in_plane(mesh.positions[triangle[(corner + 2) % 3]] - at, normal);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Numbers the vertices such that those equal in position, normal and texture coordinates share a number.
std::vector<std::uint32_t> welded_numbers(const Mesh& mesh, const std::vector<Vector2f>& uv) {
  const auto key = [&](std::uint32_t i) {
    const Vector3f &p = mesh.positions[i], &n = mesh.normals[i];
    return std::array{p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), uv[i].x(), uv[i].y()};
  };
  std::vector<std::uint32_t> order(mesh.positions.size()), numbers(order.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < order.size(); ++i)
    numbers[order[i]] = numbers[order[i - 1]] + (key(order[i - 1]) < key(order[i]));
  return numbers;
}

template <class T>
void repeat(std::vector<T>& values, int index) {
  if (!values.empty()) values.push_back(T(values[index]));
}

/// A triangle's ∂position/∂u, and whether its uv are mirrored. As v points down in glTF, a front face with u
/// to the right and v down is not mirrored.
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

void make_tangents(Mesh& mesh, const TextureSlot& slot) {
  std::vector<Vector2f> uv = slot.uv_set == 1 ? mesh.uv1 : mesh.uv0;
  for (Vector2f& coordinate : uv) coordinate = slot.uv_transform * coordinate;

  // Sums for unmirrored [0] and mirrored [1] triangles at each welded vertex.
  const std::vector<std::uint32_t> welded = welded_numbers(mesh, uv);
  const std::size_t vertices = mesh.positions.size();
  std::array<std::vector<Vector3f>, 2> sums;
  sums.fill(std::vector<Vector3f>(vertices, Vector3f::Zero()));
  std::vector<UvFrame> frames;
  frames.reserve(mesh.triangles.size());
  for (const Vector3i& triangle : mesh.triangles) {
    frames.push_back(uv_frame(mesh, uv, triangle));
    for (int c = 0; c < 3; ++c) {
      const Vector3f tangent = in_plane(frames.back().along_u, mesh.normals[triangle[c]]);
      if (tangent.allFinite())
        sums[frames.back().mirrored][welded[triangle[c]]] += corner_angle(mesh, triangle, c) * tangent;
    }
  }

  const auto tangent_at = [&](std::size_t vertex, bool mirrored) {
    Vector3f tangent = sums[mirrored][welded[vertex]].stableNormalized();
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
