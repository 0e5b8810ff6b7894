#include <catch2/catch.hpp>

#include "numbers/angles.h"
#include "random/counter_hash.h"
#include "renderer/paths/surface.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

/// A ray onto the middle of the xy quad around the origin, from +z, `slant` from its normal.
Ray towards_origin(double slant_deg) {
  Ray ray;
  ray.direction = Vec3(static_cast<float>(-std::sin(radians(slant_deg))), 0,
                       static_cast<float>(-std::cos(radians(slant_deg))));
  ray.origin = -3 * ray.direction + Vec3(0.01f, 0.02f, 0);
  return ray;
}

Texture uniform_texture(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  Texture t;
  t.name = "uniform";
  t.width = t.height = 1;
  t.rgba = {r, g, b, 255};
  return t;
}

}  // namespace

TEST_CASE("Texture (0, 0) is the top-left corner of the picture") {
  Scene scene;
  Texture t;
  t.name = "corners";
  t.width = t.height = 2;
  t.nearest = true;
  t.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  scene.textures.push_back(t);
  Material m = material({0, 0, 0, 1});
  m.emissive = {1, 1, 1};
  m.emissive_texture.texture = 0;
  scene.materials.push_back(m);
  add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  const RenderScene built(scene, constant_light(0));
  const OIIO::ImageBuf image = render(built, camera({0, 0, 2}, {0, 0, 0}, 4, 4, 40), {.samples = 4});
  CHECK((pixel(image, 0, 0) - Color(1, 0, 0)).abs().maxCoeff() < 1e-5f);
  CHECK((pixel(image, 3, 0) - Color(0, 1, 0)).abs().maxCoeff() < 1e-5f);
  CHECK((pixel(image, 0, 3) - Color(0, 0, 1)).abs().maxCoeff() < 1e-5f);
  CHECK((pixel(image, 3, 3) - Color(1, 1, 1)).abs().maxCoeff() < 1e-5f);
}

TEST_CASE("A normal map tilts towards tangent and bitangent, on fronts and backs") {
  Scene scene;
  scene.textures = {uniform_texture(200, 128, 240), uniform_texture(128, 200, 240)};
  for (int i = 0; i < 2; ++i) {
    scene.materials.push_back(material({0.5f, 0.5f, 0.5f, 1}));
    scene.materials[i].normal_texture.texture = i;
    scene.materials[i].double_sided = true;
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, i),
        Eigen::Affine3f(Eigen::Translation3f(0, 0, static_cast<float>(-10 * i))));
  }
  const RenderScene built(scene, constant_light(1));
  for (int i = 0; i < 2; ++i) {
    Ray ray;
    ray.origin = {0.1f, 0.1f, static_cast<float>(1 - 10 * i)};
    ray.direction = {0, 0, -1};
    const Vec3 n = make_surface(built.placed, ray, built.bvh.intersect(ray), 0.001f, 0).shading.normal;
    CHECK(n[i] > 0.4f);
    CHECK(std::abs(n[1 - i]) < 0.02f);
    CHECK(n.z() > 0.7f);
    ray.origin.z() -= 2;
    ray.direction.z() = 1;
    const Vec3 back = make_surface(built.placed, ray, built.bvh.intersect(ray), 0.001f, 0).shading.normal;
    CHECK((back + n).norm() < 1e-4f);
  }
}

TEST_CASE("No shading normal hides from the viewer or reflects him into the surface") {
  Scene scene;
  scene.textures = {uniform_texture(255, 60, 140)};
  scene.materials = {material({0.5f, 0.5f, 0.5f, 1})};
  scene.materials[0].normal_texture.texture = 0;
  add(scene, quad({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}));
  const RenderScene built(scene, constant_light(1));
  for (double slant : {-89.0, -80.0, -40.0, 0.0, 40.0, 80.0, 89.0}) {
    const Ray ray = towards_origin(slant);
    const Surface s = make_surface(built.placed, ray, built.bvh.intersect(ray), 0.001f, 0);
    const Vec3 wo = -ray.direction;
    CHECK(s.shading.normal.norm() == Approx(1).margin(1e-4));
    CHECK(s.shading.normal.dot(wo) > 0);
    CHECK((2 * s.shading.normal.dot(wo) * s.shading.normal - wo).dot(s.geometric_normal) > 0);
  }
}

TEST_CASE("A pixel's footprint picks the mip level whose texels it covers") {
  // A chessboard of squares of 16 texels: pure in a square's middle up to level 4, grey from level 5 on, and
  // in between in proportion. 4 m hold 512 texels.
  Scene scene;
  Texture board;
  board.name = "chessboard";
  board.width = board.height = 256;
  for (int i = 0; i < 256 * 256; ++i) {
    const auto value = static_cast<std::uint8_t>((i % 256 / 16 + i / 256 / 16) % 2 * 255);
    board.rgba.insert(board.rgba.end(), {value, value, value, 255});
  }
  scene.textures.push_back(board);
  scene.materials = {material({1, 1, 1, 1})};
  scene.materials[0].base_color_texture.texture = 0;
  scene.materials[0].base_color_texture.uv_transform.linear() *= 2;
  add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}));
  const RenderScene built(scene, constant_light(1));
  const auto seen_level = [&](double slant_deg, double width_texels) {
    Ray ray = towards_origin(slant_deg);
    const Vec3 square_middle(40 / 128.0f, 8 / 128.0f, 0);  // off the diagonal between triangles
    ray.origin = square_middle - 3 * ray.direction;
    const Surface surface =
        make_surface(built.placed, ray, built.bvh.intersect(ray), static_cast<float>(width_texels / 128), 0);
    const double white = std::abs(surface.base_color.x() - 0.5f) * 2;  // 1 at level 4, 0 at level 5
    return 5 - white;
  };
  // 8 bits hold the grey of level 5.
  CHECK(seen_level(0, std::exp2(4.0)) == Approx(4).margin(1.0 / 255));
  CHECK(seen_level(0, std::exp2(4.25)) == Approx(4.25).margin(1.0 / 255));
  CHECK(seen_level(0, std::exp2(4.75)) == Approx(4.75).margin(1.0 / 255));
  // Seen at a slant the footprint is longer; a lookup averages a square of its area.
  CHECK(seen_level(60, std::exp2(4.0)) == Approx(4.5).margin(1.0 / 255));
}

TEST_CASE("A texture is read by the set of coordinates that its slot names") {
  // Set 0 shows the texture's left texel, set 1 the right one.
  Scene scene;
  Texture halves;
  halves.name = "halves";
  halves.width = 2;
  halves.height = 1;
  halves.nearest = true;
  halves.rgba = {255, 0, 0, 255, 0, 0, 255, 51};
  scene.textures.push_back(halves);
  Mesh mesh = quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  mesh.uv0.assign(4, {0.25f, 0.5f});
  mesh.uv1.assign(4, {0.75f, 0.5f});
  scene.materials = {material({1, 1, 1, 1})};
  scene.materials[0].alpha_mode = AlphaMode::mask;
  scene.materials[0].base_color_texture.texture = 0;
  add(scene, mesh);
  const Ray ray = towards_origin(0);
  for (int set : {0, 1}) {
    CAPTURE(set);
    scene.materials[0].base_color_texture.uv_set = set;
    scene.materials[0].alpha_cutoff = 0;
    const RenderScene built(scene, constant_light(1));
    const Hit hit = built.bvh.intersect(ray);
    REQUIRE(hit);
    const Geometry& geometry = built.placed.geometries[0];
    CHECK(make_surface(built.placed, ray, hit, 0.001f, 0).base_color.x() == (set == 0 ? 1 : 0));
    CHECK(geometry.alpha(hit.triangle, hit.u, hit.v) == Approx(set == 0 ? 1 : 0.2));
    scene.materials[0].alpha_cutoff = 0.5f;  // holes are cut by the same set
    CHECK(static_cast<bool>(RenderScene(scene, constant_light(1)).bvh.intersect(ray)) == (set == 0));
  }
}

TEST_CASE("Rays that leave a surface do not meet it again, however large the coordinates") {
  for (float offset : {0.0f, 100.0f, 3000.0f}) {
    CAPTURE(offset);
    const Vec3 tilt = Vec3(1, 0.37f, 0).normalized();
    const RenderScene built(
        scene_of(material({1, 1, 1, 1}),
                 quad(Vec3(offset, 2, offset) - 50 * tilt + Vec3(0, 0, 50), 100 * tilt, {0, 0, -100})),
        constant_light(1));
    const Vec3 normal = tilt.cross(Vec3(0, 0, -1));
    int met = 0, missed = 0;
    for (int i = 0; i < 5000; ++i) {
      const Stream s = substream(make_stream(4, "points"), i);
      const Vec3 at = Vec3(offset, 2, offset) + static_cast<float>(random_uniform(s, 0, -49, 49)) * tilt +
                      Vec3(0, 0, static_cast<float>(random_uniform(s, 1, -49, 49)));
      Ray ray;
      ray.direction = (-normal + 0.9f * tilt).normalized();
      ray.origin = at - 5 * ray.direction;
      const Hit hit = built.bvh.intersect(ray);
      if (!hit) {
        ++missed;
        continue;
      }
      const Surface surface = make_surface(built.placed, ray, hit, 0, 0);
      REQUIRE(surface.clearance < 0.02f);
      const Vec3 grazing = (0.02f * normal + tilt * (i % 2 ? 1.0f : -1.0f)).normalized();
      met += built.bvh.transmittance(surface.leave(grazing)).x() < 1;
      met += static_cast<bool>(built.bvh.intersect(surface.leave(normal)));
    }
    CHECK(met == 0);
    CHECK(missed == 0);
  }
}
