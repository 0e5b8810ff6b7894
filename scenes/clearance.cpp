#include "scenes/clearance.h"

#include <embree3/rtcore.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace cps {

struct ClearanceQuery::Geometry {
  // One instruction set everywhere: a place must not be rejected on one machine and taken on another.
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
  // Embree reads 16 bytes at the last vertex, so it gets a copy of its own.
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

RTCRayHit cast_ray(const ClearanceQuery& query, const Eigen::Vector3f& from,
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
  rtcIntersect1(query.geometry->scene, &context, &hit);
  return hit;
}

/// Evenly spread over the sphere: a Fibonacci lattice (González 2010).
const std::array<Eigen::Vector3f, 256>& directions() {
  static const auto lattice = [] {
    std::array<Eigen::Vector3f, 256> unit;
    for (std::size_t i = 0; i < unit.size(); ++i) {
      const double y = 1 - (2.0 * i + 1) / unit.size(), radius = std::sqrt(1 - y * y);
      const double turn = 2 * std::numbers::pi * std::fmod(i * (std::numbers::phi - 1), 1.0);
      unit[i] = Eigen::Vector3d(radius * std::cos(turn), y, radius * std::sin(turn)).cast<float>();
    }
    return unit;
  }();
  return lattice;
}

}  // namespace

ClearanceQuery::ClearanceQuery(const Scene& scene) : geometry(std::make_unique<Geometry>()) {
  std::vector<RTCScene> meshes;
  for (const Mesh& mesh : scene.meshes) meshes.push_back(committed_mesh(geometry->device, mesh));
  geometry->scene = rtcNewScene(geometry->device);
  rtcSetSceneFlags(geometry->scene, RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    RTCGeometry placed = rtcNewGeometry(geometry->device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(placed, meshes[instance.mesh]);
    const Eigen::Matrix4f transform = instance.world_from_mesh.matrix();
    rtcSetGeometryTransform(placed, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, transform.data());
    rtcCommitGeometry(placed);
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

ClearanceQuery::~ClearanceQuery() = default;
ClearanceQuery::ClearanceQuery(ClearanceQuery&&) noexcept = default;

bool is_clear(const ClearanceQuery& query, const Eigen::Vector3d& position, const Eigen::Vector3d& forward,
              double min_distance_m) {
  constexpr float cos_ahead = 0.7071f, cos_ground_slope = 0.7071f;  // 45°
  const Eigen::Vector3f from = position.cast<float>(), ahead = forward.normalized().cast<float>();
  std::size_t backs = 0;
  for (const Eigen::Vector3f& direction : directions()) {
    const RTCRayHit hit = cast_ray(query, from, direction);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    const ClearanceQuery::Geometry::Surface& surface = query.geometry->surfaces[hit.hit.instID[0]];
    const Eigen::Vector3f normal =
        (surface.world_from_mesh_normal * Eigen::Vector3f(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z))
            .normalized();
    const bool shows_back = normal.dot(direction) > 0;
    backs += shows_back && !surface.double_sided;
    const bool is_ground = direction.y() < 0 && std::abs(normal.y()) > cos_ground_slope;
    if (direction.dot(ahead) > cos_ahead && !is_ground && hit.ray.tfar < min_distance_m) return false;
  }
  return backs * 3 < directions().size();
}

}  // namespace cps
