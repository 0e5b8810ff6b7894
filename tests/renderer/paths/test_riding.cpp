#include <catch2/catch.hpp>

#include "random/counter_hash.h"
#include "scenes/rig.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

/// A floor and a ball, 2 m ahead of the vehicle frame's origin and 1 m above it.
Scene floor_and_ball(const Eigen::Affine3f& world_from_ball, bool rides) {
  Scene scene;
  scene.materials = {lambert({0.5f, 0.5f, 0.5f, 1})};
  scene.meshes = {quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}), sphere(0.5f)};
  scene.instances = {{.mesh = 0}, {.mesh = 1, .world_from_mesh = world_from_ball, .rides = rides}};
  return scene;
}

const Eigen::Affine3f vehicle_from_ball(Eigen::Translation3f(2, 0, 1));

}  // namespace

TEST_CASE("What rides with the car shades what is below it, for rays that run alike too") {
  RenderScene riding(floor_and_ball(vehicle_from_ball, true), constant_light(1));
  const Place place{.position = {3, 0, -4}, .heading_rad = 0.7};
  put_car(riding, world_from_vehicle(place));
  const Eigen::Affine3f world_from_ball = world_from_vehicle(place).cast<float>() * vehicle_from_ball;
  int in_shadow = 0;
  for (int i = 0; i < 200; ++i) {
    Ray rays[packet_size];
    bool active[packet_size];
    const Stream stream = substream(make_stream(9, "rays"), i);
    for (int lane = 0; lane < packet_size; ++lane) {
      const auto around = [&](int n) {
        return static_cast<float>(random_uniform(stream, 2 * lane + n, -1, 1));
      };
      rays[lane].origin = world_from_ball.translation() + Vec3(around(0), -0.9f, around(1));
      rays[lane].direction = Vec3(0.02f, 1, 0.01f).normalized();  // up from the floor, in one octant
      active[lane] = true;
    }
    Color light[packet_size];
    riding.bvh.transmittance_coherent(rays, active, light);
    for (int lane = 0; lane < packet_size; ++lane) {
      const Vec3 to_ball = world_from_ball.translation() - rays[lane].origin;
      const float off_m = to_ball.cross(rays[lane].direction).norm();
      if (std::abs(off_m - 0.5f) < 0.01f) continue;  // the ball is made of flat faces
      CHECK((light[lane].maxCoeff() == 0) == (off_m < 0.5f));
      in_shadow += off_m < 0.5f;
    }
  }
  CHECK(in_shadow > 200);
}

TEST_CASE("What rides with the car is where the car is put, for all kinds of rays") {
  RenderScene riding(floor_and_ball(vehicle_from_ball, true), constant_light(1));
  for (int p = 0; p < 3; ++p) {
    const Place place{
        .position = {3.0 * p, 0.5 * p, -4.0 * p}, .heading_rad = 0.7 * p, .pitch_rad = 0.05 * p};
    const Eigen::Isometry3d world_from_vehicle = cps::world_from_vehicle(place);
    put_car(riding, world_from_vehicle);
    const Eigen::Affine3f world_from_ball = world_from_vehicle.cast<float>() * vehicle_from_ball;
    const RenderScene still(floor_and_ball(world_from_ball, false), constant_light(1));
    int on_ball = 0, in_shadow = 0;
    const Stream stream = substream(make_stream(8, "rays"), p);
    const auto around = [&](int i) { return static_cast<float>(random_uniform(stream, i, -1, 1)); };
    for (int i = 0; i < 500; ++i) {
      Ray rays[packet_size];
      bool active[packet_size];
      Hit hits[packet_size];
      for (int lane = 0; lane < packet_size; ++lane) {
        const int n = 4 * (packet_size * i + lane);
        rays[lane].origin = world_from_ball.translation() + Vec3(around(n), 5, around(n + 1));
        rays[lane].direction = Vec3(0.1f * around(n + 2), -1, 0.1f * around(n + 3)).normalized();
        active[lane] = true;
      }
      riding.bvh.intersect_coherent(rays, active, hits);
      Color light[packet_size];
      riding.bvh.transmittance_coherent(rays, active, light);
      for (int lane = 0; lane < packet_size; ++lane) {
        const Hit expected = still.bvh.intersect(rays[lane]);
        REQUIRE(expected);
        for (const Hit& hit : {hits[lane], riding.bvh.intersect(rays[lane])}) {
          REQUIRE(hit.placement == expected.placement);
          REQUIRE(hit.t == Approx(expected.t).margin(2e-3));
        }
        on_ball += expected.placement == 1;
        Ray short_of_floor = rays[lane];
        short_of_floor.t_far = still.bvh.intersect(rays[lane]).t + 0.1f;
        CHECK(riding.bvh.transmittance(short_of_floor).maxCoeff() == 0);
        short_of_floor.t_far = 5.3f;  // above the floor, below the ball's top
        const bool is_shaded = still.bvh.transmittance(short_of_floor).maxCoeff() == 0;
        CHECK((riding.bvh.transmittance(short_of_floor).maxCoeff() == 0) == is_shaded);
        in_shadow += is_shaded;
        CHECK(light[lane].maxCoeff() == 0);
      }
    }
    CHECK(on_ball > 300);
    CHECK(in_shadow > 300);
    CHECK(in_shadow < 4000);
  }
}

TEST_CASE(
    "Rays that do not meet the car pass what rides with it and nothing else, one by one and in packets") {
  const RenderScene riding(floor_and_ball(vehicle_from_ball, true), constant_light(1));
  const RenderScene still(floor_and_ball(vehicle_from_ball, false), constant_light(1));
  for (const bool from_viewer : {false, true})
    for (const RenderScene* scene : {&riding, &still}) {
      Ray rays[packet_size];
      bool active[packet_size];
      for (int lane = 0; lane < packet_size; ++lane) {
        rays[lane] = {.origin = vehicle_from_ball.translation() + Vec3(0.02f * float(lane), 3, 0),
                      .direction = Vec3(0.01f, -1, 0.01f).normalized(),
                      .from_viewer = from_viewer,
                      .meets_car = lane % 2 == 0};
        active[lane] = true;
      }
      Hit hits[packet_size];
      scene->bvh.intersect_coherent(rays, active, hits);
      for (Ray& ray : rays) ray.t_far = 2.9f;  // above the floor, below the ball
      Color light[packet_size];
      scene->bvh.transmittance_coherent(rays, active, light);
      for (int lane = 0; lane < packet_size; ++lane) {
        const bool passes = scene == &riding && lane % 2 == 1;
        const float fraction = passes ? 1.0f : 0.0f;
        CAPTURE(from_viewer, passes, lane);
        CHECK(hits[lane].placement == (passes ? 0u : 1u));
        CHECK(light[lane].x() == fraction);
        CHECK(scene->bvh.transmittance(rays[lane]).x() == fraction);
        rays[lane].t_far = std::numeric_limits<float>::infinity();
        CHECK(scene->bvh.intersect(rays[lane]).placement == (passes ? 0u : 1u));
        CHECK(scene->bvh.intersect_shown(rays[lane]).placement == (passes ? 0u : 1u));
      }
    }
}
