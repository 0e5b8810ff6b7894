#include "renderer/geometry/trace.h"

#include <tbb/task_arena.h>

#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "renderer/geometry/alpha_filter.h"

namespace cps {
namespace {

static_assert(Hit::no_placement == RTC_INVALID_GEOMETRY_ID);
static_assert(packet_size == std::extent_v<decltype(RTCRay8::tfar)>);

/// Embree tests a ray against a geometry where their masks share a bit.
constexpr unsigned viewer_mask = 1, light_mask = 2, car_mask = 4;

unsigned mask_of(const Ray& ray) {
  return (ray.from_viewer ? viewer_mask : light_mask) | (ray.meets_car ? car_mask : 0);
}

RTCGeometry make_triangles(RTCDevice device, const Geometry& geometry) {
  RTCGeometry triangles = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             geometry.vertices.data(), 0, sizeof(PackedVertex), geometry.vertices.size());
  rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, geometry.triangles.data(),
                             0, sizeof(Eigen::Vector3i), geometry.triangles.size());
  set_alpha_filters(triangles, geometry);
  rtcSetGeometryMask(triangles, geometry.viewer_only ? viewer_mask : viewer_mask | light_mask);
  rtcCommitGeometry(triangles);
  return triangles;
}

void set_transform(RTCGeometry instance, const Placement& placement) {
  const Eigen::Matrix<float, 3, 4> columns = placement.world_from_mesh.matrix().topRows<3>();
  rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
}

RTCGeometry make_instance(RTCDevice device, RTCScene shared, const Placement& placement) {
  RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(instance, shared);
  set_transform(instance, placement);
  rtcSetGeometryMask(instance, placement.rides ? car_mask : viewer_mask | light_mask);
  rtcCommitGeometry(instance);
  return instance;
}

/// Passes the backs of single-sided materials. For single rays only.
void filter_backs(const RTCFilterFunctionNArguments* args) {
  const auto& geometry = *static_cast<const Geometry*>(args->geometryUserPtr);
  if (geometry.material->double_sided) return;
  const Vec3 normal(RTCHitN_Ng_x(args->hit, 1, 0), RTCHitN_Ng_y(args->hit, 1, 0),
                    RTCHitN_Ng_z(args->hit, 1, 0));
  const Vec3 direction(RTCRayN_dir_x(args->ray, 1, 0), RTCRayN_dir_y(args->ray, 1, 0),
                       RTCRayN_dir_z(args->ray, 1, 0));
  if (normal.dot(direction) > 0.0f) args->valid[0] = 0;
}

/// Without Embree's robust traversal, which costs 12 % of the time: a few rays in ten million slip between
/// triangles that share an edge.
RTCScene new_scene(RTCDevice device) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
  return scene;
}

void check(RTCDevice device) {
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE) {
    throw std::runtime_error(error == RTC_ERROR_OUT_OF_MEMORY
                                 ? "ray tracing: out of memory for the BVH"
                                 : "ray tracing: Embree error " + std::to_string(error));
  }
}

RTCRay to_embree(const Ray& ray) {
  RTCRay r;
  r.org_x = ray.origin.x(), r.org_y = ray.origin.y(), r.org_z = ray.origin.z();
  r.dir_x = ray.direction.x(), r.dir_y = ray.direction.y(), r.dir_z = ray.direction.z();
  r.tnear = ray.t_near, r.tfar = ray.t_far;
  r.time = 0, r.mask = mask_of(ray), r.id = ray.id, r.flags = 0;
  return r;
}

Hit nearest(RTCScene scene, RTCScene riding, const Ray& ray, RTCFilterFunctionN filter) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.filter = filter;
  RTCRayHit query;
  query.ray = to_embree(ray);
  query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &query);
  if (riding) rtcIntersect1(riding, &context, &query);
  const RTCHit& hit = query.hit;
  return {hit.instID[0] != RTC_INVALID_GEOMETRY_ID ? hit.instID[0] : hit.geomID, hit.primID, hit.u, hit.v,
          query.ray.tfar};
}

void set_lane(RTCRay8& rays, int lane, const Ray& ray) {
  rays.org_x[lane] = ray.origin.x(), rays.org_y[lane] = ray.origin.y(), rays.org_z[lane] = ray.origin.z();
  rays.dir_x[lane] = ray.direction.x(), rays.dir_y[lane] = ray.direction.y(),
  rays.dir_z[lane] = ray.direction.z();
  rays.tnear[lane] = ray.t_near, rays.tfar[lane] = ray.t_far;
  rays.time[lane] = 0, rays.mask[lane] = mask_of(ray), rays.id[lane] = ray.id, rays.flags[lane] = 0;
}

bool in_one_octant(const Ray (&rays)[packet_size], const bool (&active)[packet_size]) {
  int octants = 0;
  for (int lane = 0; lane < packet_size; ++lane) {
    if (!active[lane]) continue;
    const Vec3& d = rays[lane].direction;
    octants |= 1 << (std::signbit(d.x()) | std::signbit(d.y()) << 1 | std::signbit(d.z()) << 2);
  }
  return std::has_single_bit(static_cast<unsigned>(octants));
}

}  // namespace

void Bvh::Release::operator()(RTCDeviceTy* device) const {
  rtcReleaseDevice(device);
}

void Bvh::Release::operator()(RTCSceneTy* scene) const {
  rtcReleaseScene(scene);
}

Bvh::Bvh(const PlacedGeometry& placed) : device(rtcNewDevice("isa=avx2")) {
  if (!device) throw std::runtime_error("ray tracing: Embree found no AVX2 on this machine");
  tbb::task_arena one_thread(1);
  one_thread.execute([&] {
    shared_scenes.resize(placed.geometries.size());
    scene.reset(new_scene(device.get()));
    for (std::size_t i = 0; i < placed.placements.size(); ++i) {
      const Placement& placement = placed.placements[i];
      const Geometry& geometry = placed.geometries[placement.geometry];
      SceneHandle& shared = shared_scenes[placement.geometry];
      if (placement.shared && !shared) {
        shared.reset(new_scene(device.get()));
        RTCGeometry triangles = make_triangles(device.get(), geometry);
        rtcAttachGeometryByID(shared.get(), triangles, 0);
        rtcReleaseGeometry(triangles);
        rtcCommitScene(shared.get());
      }
      RTCGeometry embree = placement.shared ? make_instance(device.get(), shared.get(), placement)
                                            : make_triangles(device.get(), geometry);
      if (placement.rides && !riding) riding.reset(new_scene(device.get()));
      rtcAttachGeometryByID(placement.rides ? riding.get() : scene.get(), embree, static_cast<unsigned>(i));
      rtcReleaseGeometry(embree);
    }
    rtcCommitScene(scene.get());
    if (riding) rtcCommitScene(riding.get());
  });
  check(device.get());
}

void Bvh::move_riding(const PlacedGeometry& placed) {
  tbb::task_arena one_thread(1);
  one_thread.execute([&] {
    for (std::size_t i = 0; i < placed.placements.size(); ++i) {
      if (!placed.placements[i].rides) continue;
      RTCGeometry instance = rtcGetGeometry(riding.get(), static_cast<unsigned>(i));
      set_transform(instance, placed.placements[i]);
      rtcCommitGeometry(instance);
    }
    rtcCommitScene(riding.get());
  });
  check(device.get());
}

Hit Bvh::intersect(const Ray& ray) const {
  return nearest(scene.get(), riding.get(), ray, nullptr);
}

Hit Bvh::intersect_shown(const Ray& ray) const {
  return nearest(scene.get(), riding.get(), ray, filter_backs);
}

void Bvh::intersect_coherent(const Ray (&rays)[packet_size], const bool (&active)[packet_size],
                             Hit (&hits)[packet_size]) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit8 query;
  alignas(32) int valid[packet_size];
  for (int lane = 0; lane < packet_size; ++lane) {
    valid[lane] = active[lane] ? -1 : 0;
    set_lane(query.ray, lane, rays[lane]);
    query.hit.geomID[lane] = query.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect8(valid, scene.get(), &context, &query);
  if (riding) rtcIntersect8(valid, riding.get(), &context, &query);
  const RTCHit8& hit = query.hit;
  for (int lane = 0; lane < packet_size; ++lane) {
    const bool instanced = hit.instID[0][lane] != RTC_INVALID_GEOMETRY_ID;
    hits[lane] = {instanced ? hit.instID[0][lane] : hit.geomID[lane], hit.primID[lane], hit.u[lane],
                  hit.v[lane], query.ray.tfar[lane]};
  }
}

Color Bvh::transmittance(const Ray& ray) const {
  ShadowContext context;
  RTCRay query = to_embree(ray);
  query.id = 0;
  rtcOccluded1(scene.get(), &context.embree, &query);
  if (riding && query.tfar >= 0.0f) rtcOccluded1(riding.get(), &context.embree, &query);
  return query.tfar < 0.0f ? Color(Color::Zero()) : context.transmittance[0];
}

void Bvh::transmittance_coherent(const Ray (&rays)[packet_size], const bool (&active)[packet_size],
                                 Color (&transmittance)[packet_size]) const {
  // Embree splits a packet by the octants of its directions and offers each leaf to all rays once per octant:
  // filters would tint twice.
  if (!in_one_octant(rays, active)) {
    for (int lane = 0; lane < packet_size; ++lane)
      if (active[lane]) transmittance[lane] = this->transmittance(rays[lane]);
    return;
  }
  ShadowContext context;
  context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRay8 query;
  alignas(32) int valid[packet_size];
  for (int lane = 0; lane < packet_size; ++lane) {
    valid[lane] = active[lane] ? -1 : 0;
    set_lane(query, lane, rays[lane]);
    query.id[lane] = static_cast<unsigned>(lane);
  }
  rtcOccluded8(valid, scene.get(), &context.embree, &query);
  if (riding) rtcOccluded8(valid, riding.get(), &context.embree, &query);
  for (int lane = 0; lane < packet_size; ++lane) {
    transmittance[lane] = query.tfar[lane] < 0.0f ? Color(Color::Zero()) : context.transmittance[lane];
  }
}

}  // namespace cps
