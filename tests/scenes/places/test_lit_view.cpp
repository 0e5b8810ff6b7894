#include <catch2/catch.hpp>

#include "scenes/places/lit_view.h"
#include "scenes/surface_color.h"
#include "tests/scenes/box.h"

using namespace cps;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

const Vector3d looking_east(1, 0, 0), eye(0, 1.65, 0);

/// A room of six slabs, 20 m × 6 m × 20 m inside; its east wall has a hole of `hole_m` × `hole_m` at the
/// eye's height.
Scene room(float albedo, float hole_m = 0) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].base_color.head<3>().setConstant(albedo);
  scene.meshes = {box()};
  add_box(scene, {-11, -1, -11}, {11, 0, 11});
  add_box(scene, {-11, 6, -11}, {11, 7, 11});
  add_box(scene, {-11, 0, -11}, {-10, 6, 11});
  add_box(scene, {-11, 0, -11}, {11, 6, -10});
  add_box(scene, {-11, 0, 10}, {11, 6, 11});
  add_box(scene, {10, 0, -11}, {11, 6, -hole_m / 2});
  add_box(scene, {10, 0, hole_m / 2}, {11, 6, 11});
  return scene;
}

PlaceFault fault_in(const Scene& scene) {
  return light_fault(SceneRays(scene), scene_light(scene), eye, looking_east);
}

}  // namespace

TEST_CASE("a closed room is dark, and a lamp or a shining wall lights it") {
  Scene scene = room(0.5f);
  CHECK(fault_in(scene) == PlaceFault::dark);

  scene.lights = {{.name = "lamp", .position = {0, 5, 0}, .intensity = {0.1f, 0.1f, 0.1f}}};
  CHECK(fault_in(scene) == PlaceFault::none);
  scene.lights[0].position = {0, 9, 0};  // above the ceiling
  CHECK(fault_in(scene) == PlaceFault::dark);
  scene.lights[0] = {.name = "torch",
                     .kind = PunctualLight::Kind::spot,
                     .position = {-5, 3, 0},
                     .direction = {1, 0, 0},
                     .intensity = {1, 1, 1},
                     .cos_outer = 0.7f};
  CHECK(fault_in(scene) == PlaceFault::none);
  scene.lights[0].direction = {-1, 0, 0};  // at the wall behind
  CHECK(fault_in(scene) == PlaceFault::dark);

  scene.lights.clear();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].emissive = {1, 1, 1};
  scene.meshes.push_back(box());
  scene.meshes[1].material = 1;
  scene.instances[1].mesh = 1;  // the ceiling
  CHECK(fault_in(scene) == PlaceFault::none);
}

TEST_CASE("an open street is lit, and a lattice of a few openings is enough") {
  Scene scene = room(0.5f);
  scene.instances.erase(scene.instances.begin() + 1);  // the ceiling
  CHECK(fault_in(scene) == PlaceFault::none);
}

TEST_CASE("a bright opening in a black room blows out, in a room that reflects it does not") {
  CHECK(fault_in(room(0, 20)) == PlaceFault::blown_out);
  CHECK(fault_in(room(0.5f, 20)) == PlaceFault::none);
}

TEST_CASE("the mean colour of a texture is that of its linear texels") {
  Texture texture{.name = "stripes", .width = 256, .height = 256, .rgba = {}, .srgb = true};
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const std::uint8_t value = x % 2 ? 255 : 0;
      texture.rgba.insert(texture.rgba.end(), {value, value, 128, 255});
    }
  const Vector3f mean = mean_color(texture);
  CHECK(mean.x() == Approx(0.5).margin(0.03));
  CHECK(mean.z() == Approx(0.2158605).epsilon(1e-4));  // IEC 61966-2-1 of 128/255
  Scene scene;
  scene.textures = {texture};
  Material material;
  material.base_color = {0.5f, 1, 1, 1};
  material.base_color_texture.texture = 0;
  CHECK(mean_base_color(scene, material).x() == Approx(0.25).margin(0.02));
  CHECK(mean_emission(scene, material) == Vector3f::Zero());
  material.unlit = true;
  CHECK(mean_emission(scene, material) == mean_base_color(scene, material));
}
