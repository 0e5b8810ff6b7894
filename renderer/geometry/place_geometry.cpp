#include "renderer/geometry/place_geometry.h"

#include <tbb/parallel_for.h>

#include <stdexcept>
#include <string>

#include "scenes/inside_out.h"

namespace cps {
namespace {

/// Copies of a mesh are flattened up to this many triangles in all: a BVH without instance transforms is
/// faster.
constexpr std::size_t flatten_up_to_triangles = 20000;

void check_mesh(const Scene& scene, const Mesh& mesh) {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error("mesh '" + mesh.name + "': " + what);
  };
  const std::size_t vertices = mesh.positions.size();
  if (mesh.material < 0 || mesh.material >= static_cast<int>(scene.materials.size()))
    fail("names a material that the scene does not have");
  if (mesh.normals.size() != vertices || mesh.uv0.size() != vertices)
    fail("needs a normal and a uv0 for every position");
  const auto may_be_empty = [&](std::size_t size) { return size == 0 || size == vertices; };
  if (!may_be_empty(mesh.uv1.size()) || !may_be_empty(mesh.tangents.size()) ||
      !may_be_empty(mesh.colors.size())) {
    fail("uv1, tangents and colors must be empty or one per position");
  }
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    if (triangle.minCoeff() < 0 || static_cast<std::size_t>(triangle.maxCoeff()) >= vertices)
      fail("a triangle names a vertex that it does not have");
  }
  const auto all_finite = [](const auto& values) {
    for (const auto& value : values)
      if (!value.allFinite()) return false;
    return true;
  };
  if (!all_finite(mesh.positions) || !all_finite(mesh.normals) || !all_finite(mesh.uv0) ||
      !all_finite(mesh.uv1) || !all_finite(mesh.tangents) || !all_finite(mesh.colors)) {
    fail("every vertex attribute must be finite");
  }
  const Material& material = scene.materials[mesh.material];
  const bool has_normal_map =
      material.normal_texture.texture >= 0 || material.clearcoat_normal_texture.texture >= 0;
  if (has_normal_map && mesh.tangents.empty()) fail("its material has a normal map, so it needs tangents");
  for (const TextureSlot* slot : texture_slots(material)) {
    if (slot->texture >= 0 && slot->uv_set == 1 && mesh.uv1.empty())
      fail("its material reads uv1, which it does not have");
  }
}

/// The mesh under a transform (the identity for shared geometry).
Geometry make_geometry(const Mesh& mesh, const Eigen::Affine3f& transform, const SurfaceMaterial* material) {
  Geometry geometry;
  geometry.material = material;
  const Eigen::Matrix3f linear = transform.linear();
  const bool mirrors = linear.determinant() < 0;
  const Eigen::Matrix3f normal_transform = linear.inverse().transpose();
  geometry.vertices.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    PackedVertex& vertex = geometry.vertices[i];
    vertex.position = transform * mesh.positions[i];
    const Vec3 normal = (normal_transform * mesh.normals[i]).normalized();
    vertex.normal =
        pack_direction(normal.allFinite() && normal.squaredNorm() > 0.5f ? normal : Vec3(0, 1, 0));
    vertex.uv = mesh.uv0[i];
    vertex.tangent = 0;
    vertex.bitangent_sign = 0;
    if (mesh.tangents.empty()) continue;
    const Vec3 tangent = (linear * mesh.tangents[i].head<3>()).normalized();
    if (!tangent.allFinite() || tangent.squaredNorm() < 0.5f) continue;
    vertex.tangent = pack_direction(tangent);
    vertex.bitangent_sign = (mesh.tangents[i].w() < 0) != mirrors ? -1.0f : 1.0f;
  }
  geometry.viewer_only = mesh.is_enclosure || (!material->double_sided && is_inside_out(mesh));
  geometry.triangles = mesh.triangles;
  if (mirrors) {
    for (Eigen::Vector3i& triangle : geometry.triangles) std::swap(triangle.y(), triangle.z());
  }
  geometry.uv1 = mesh.uv1;
  geometry.colors.reserve(mesh.colors.size());
  for (const Eigen::Vector4f& color : mesh.colors)
    geometry.colors.push_back(color.array().cast<Eigen::half>());
  return geometry;
}

}  // namespace

bool is_shared(const Mesh& mesh, std::size_t placements) {
  return placements > 1 && placements * mesh.triangles.size() > flatten_up_to_triangles;
}

PlacedGeometry place_geometry(const Scene& scene, const Materials& materials) {
  for (const Mesh& mesh : scene.meshes) check_mesh(scene, mesh);
  std::vector<std::size_t> copies(scene.meshes.size(), 0);
  for (const Instance& instance : scene.instances) {
    if (instance.mesh < 0 || instance.mesh >= static_cast<int>(scene.meshes.size())) {
      throw std::runtime_error("scene '" + scene.name +
                               "': an instance names a mesh that the scene does not have");
    }
    if (!instance.world_from_mesh.matrix().allFinite()) {
      throw std::runtime_error("mesh '" + scene.meshes[instance.mesh].name +
                               "': its placement must be finite");
    }
    ++copies[instance.mesh];
  }

  PlacedGeometry result;
  struct Job {
    const Mesh* mesh;
    Eigen::Affine3f transform;
  };
  std::vector<Job> jobs;
  std::vector<int> shared_geometry(scene.meshes.size(), -1);
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    // Skip what is scaled to nothing: it has no surface, and its transform no inverse.
    if (mesh.triangles.empty() || instance.world_from_mesh.linear().determinant() == 0) continue;
    Placement placement;
    placement.instance = static_cast<int>(&instance - scene.instances.data());
    placement.rides = instance.rides;
    placement.shared = instance.rides || is_shared(mesh, copies[instance.mesh]);
    if (!placement.shared) {
      placement.geometry = static_cast<int>(jobs.size());
      jobs.push_back({&mesh, instance.world_from_mesh});
    } else {
      int& geometry = shared_geometry[instance.mesh];
      if (geometry < 0) {
        geometry = static_cast<int>(jobs.size());
        jobs.push_back({&mesh, Eigen::Affine3f::Identity()});
      }
      placement.geometry = geometry;
      placement.world_from_mesh = instance.world_from_mesh;
      placement.mirrored = instance.world_from_mesh.linear().determinant() < 0;
      placement.normal_from_mesh = instance.world_from_mesh.linear().inverse().transpose();
    }
    result.placements.push_back(placement);
  }
  result.geometries.resize(jobs.size());
  tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
    result.geometries[i] =
        make_geometry(*jobs[i].mesh, jobs[i].transform, &materials.surfaces[jobs[i].mesh->material]);
  });
  return result;
}

}  // namespace cps
