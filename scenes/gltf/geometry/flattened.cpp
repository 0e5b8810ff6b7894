#include "scenes/gltf/geometry/flattened.h"

#include "scenes/gltf/geometry/normals.h"

namespace cps::gltf {
namespace {

/// What normals are multiplied by: the inverse transposed times the determinant, which a flat transform has,
/// too.
Eigen::Matrix3f cofactors(const Eigen::Matrix3f& m) {
  Eigen::Matrix3f result;
  for (int c = 0; c < 3; ++c) result.col(c) = m.col((c + 1) % 3).cross(m.col((c + 2) % 3));
  return result;
}

bool has_area(const Mesh& mesh, const Eigen::Vector3i& triangle) {
  const Eigen::Vector3f a = mesh.positions[triangle[1]] - mesh.positions[triangle[0]],
                        b = mesh.positions[triangle[2]] - mesh.positions[triangle[0]];
  constexpr float min_sine = 1e-6f;
  return a.cross(b).norm() > min_sine * a.norm() * b.norm();
}

}  // namespace

Mesh flattened(const Mesh& mesh, const Eigen::Affine3f& world_from_mesh) {
  Mesh flat = mesh;
  const Eigen::Matrix3f linear = world_from_mesh.linear(), for_normals = cofactors(linear);
  for (Eigen::Vector3f& position : flat.positions) position = world_from_mesh * position;
  for (Eigen::Vector3f& normal : flat.normals) normal = for_normals * normal;
  for (Eigen::Vector4f& tangent : flat.tangents) tangent.head<3>() = linear * tangent.head<3>();
  std::erase_if(flat.triangles, [&](const Eigen::Vector3i& triangle) { return !has_area(flat, triangle); });
  repair_normals(flat);
  for (std::size_t i = 0; i < flat.tangents.size(); ++i) {
    Eigen::Vector3f along = flat.tangents[i].head<3>();
    along -= flat.normals[i] * flat.normals[i].dot(along);
    const bool is_valid = along.norm() > 1e-6f;
    flat.tangents[i].head<3>() = is_valid ? along.normalized() : flat.normals[i].unitOrthogonal();
  }
  return flat;
}

}  // namespace cps::gltf
