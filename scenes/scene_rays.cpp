#include "scenes/scene_rays.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "scenes/inside_out.h"

namespace cps {

struct SceneRays::Geometry {
  // The same instruction set on all machines, so that all of them reject the same places.
  RTCDevice device = rtcNewDevice("isa=avx2");
  RTCScene scene = nullptr;
  struct Surface {
    Eigen::Matrix3f world_from_mesh_normal;
    bool double_sided;
  };
  std::vector<Surface> surfaces;  ///< per instance

  ~Geometry() {
    if (scene) rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

namespace {

RTCScene committed_mesh(RTCDevice device, const Mesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  // Embree reads 16 bytes at the last vertex, so it gets a padded copy.
  auto* vertices = static_cast<Eigen::Vector3f*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Eigen::Vector3f),
                              mesh.positions.size()));
  std::copy(mesh.positions.begin(), mesh.positions.end(), vertices);
  auto* triangles = static_cast<Eigen::Vector3i*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Eigen::Vector3i), mesh.triangles.size()));
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
  rtcCommitGeometry(geometry);
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

}  // namespace

SceneRays::SceneRays(const Scene& scene) : geometry(std::make_unique<Geometry>()) {
  std::vector<RTCScene> meshes;
  std::vector<bool> is_shell;
  for (const Mesh& mesh : scene.meshes) {
    meshes.push_back(committed_mesh(geometry->device, mesh));
    is_shell.push_back(mesh.is_enclosure ||
                       (!scene.materials[mesh.material].double_sided && is_inside_out(mesh)));
  }
  geometry->scene = rtcNewScene(geometry->device);
  rtcSetSceneFlags(geometry->scene, RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    RTCGeometry placed = rtcNewGeometry(geometry->device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(placed, meshes[instance.mesh]);
    const Eigen::Matrix4f transform = instance.world_from_mesh.matrix();
    rtcSetGeometryTransform(placed, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, transform.data());
    rtcCommitGeometry(placed);
    if (!is_shell[instance.mesh])
      rtcAttachGeometryByID(geometry->scene, placed, static_cast<unsigned int>(i));
    rtcReleaseGeometry(placed);
    geometry->surfaces.push_back({instance.world_from_mesh.linear().inverse().transpose(),
                                  scene.materials[scene.meshes[instance.mesh].material].double_sided});
  }
  for (RTCScene mesh : meshes) rtcReleaseScene(mesh);
  rtcCommitScene(geometry->scene);
  if (rtcGetDeviceError(geometry->device) != RTC_ERROR_NONE)
    throw std::runtime_error(scene.name +
                             ": geometry: Embree cannot build its tree, is there enough memory?");
}

SceneRays::~SceneRays() = default;
SceneRays::SceneRays(SceneRays&&) noexcept = default;

std::optional<SurfaceHit> first_hit(const SceneRays& rays, const Eigen::Vector3f& from,
                                    const Eigen::Vector3f& direction) {
  RTCRayHit hit{};
  hit.ray = {from.x(),
             from.y(),
             from.z(),
             0,
             direction.x(),
             direction.y(),
             direction.z(),
             0,
             std::numeric_limits<float>::infinity(),
             0xffffffffu,
             0,
             0};
  hit.hit.geomID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(rays.geometry->scene, &context, &hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const SceneRays::Geometry::Surface& surface = rays.geometry->surfaces[hit.hit.instID[0]];
  const Eigen::Vector3f normal =
      (surface.world_from_mesh_normal * Eigen::Vector3f(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z))
          .normalized();
  return SurfaceHit{.distance_m = hit.ray.tfar,
                    .normal = normal,
                    .shows_back = !surface.double_sided && normal.dot(direction) > 0,
                    .instance = static_cast<int>(hit.hit.instID[0]),
                    .triangle = static_cast<int>(hit.hit.primID),
                    .barycentric = {hit.hit.u, hit.hit.v}};
}

}  // namespace cps
