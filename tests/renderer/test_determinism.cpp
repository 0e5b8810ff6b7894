#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "random/counter_hash.h"
#include "tests/renderer/handmade.h"
#include "tests/same_bytes.h"

using namespace cps;
using namespace cps::handmade;

namespace {

/// Thousands of squares that touch and overlap, some masked, so that rays hit triangles at equal distances.
Scene cluttered() {
  Scene scene;
  Texture holes;
  holes.name = "holes";
  holes.width = holes.height = 16;
  for (int i = 0; i < 256; ++i) {
    const auto a = static_cast<std::uint8_t>(random_below(make_stream(1, "holes"), i, 256));
    holes.rgba.insert(holes.rgba.end(), {200, 120, 60, a});
  }
  scene.textures.push_back(holes);
  scene.materials = {material({0.7f, 0.7f, 0.7f, 1}), material({0.9f, 0.6f, 0.3f, 1}, 1, 0.3f),
                     material({1, 1, 1, 1})};
  scene.materials[2].base_color_texture.texture = 0;
  scene.materials[2].alpha_mode = AlphaMode::mask;
  scene.materials[2].double_sided = true;
  add(scene, quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}));
  Mesh clutter;
  clutter.name = "clutter";
  for (int material = 0; material < 3; ++material) {
    Mesh merged = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, material);
    for (int i = 0; i < 3000; ++i) {
      const Stream s = substream(make_stream(5, "clutter"), 3000 * material + i);
      // On a grid, so that many coincide.
      const Vec3 at(static_cast<float>(random_below(s, 0, 20)) - 10,
                    static_cast<float>(random_below(s, 1, 4)),
                    static_cast<float>(random_below(s, 2, 20)) - 10);
      const bool turned = random_below(s, 3, 2) == 1;
      const Mesh face = quad(at, turned ? Vec3(0, 0, -1) : Vec3(1, 0, 0), {0, 1, 0}, material);
      const int first = static_cast<int>(merged.positions.size());
      merged.positions.insert(merged.positions.end(), face.positions.begin(), face.positions.end());
      merged.normals.insert(merged.normals.end(), face.normals.begin(), face.normals.end());
      merged.uv0.insert(merged.uv0.end(), face.uv0.begin(), face.uv0.end());
      merged.tangents.insert(merged.tangents.end(), face.tangents.begin(), face.tangents.end());
      for (const Eigen::Vector3i& t : face.triangles)
        merged.triangles.push_back(t + Eigen::Vector3i::Constant(first));
    }
    add(scene, merged);
  }
  return scene;
}

OIIO::ImageBuf picture(int threads, const Scene& scene, int samples = 9) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const auto render_scene = build_render_scene(scene, {});
  return render(*render_scene, camera({0, 2.5, 14}, {0, 1, 0}, 70, 45, 75), {.samples = samples, .seed = 3});
}

}  // namespace

TEST_CASE("One thread or many, built and rendered: the same bytes") {
  const Scene scene = cluttered();
  const OIIO::ImageBuf one = picture(1, scene);
  for (int threads : {2, 3, 8}) CHECK(same_bytes(picture(threads, scene), one));
  CHECK(same_bytes(picture(1, scene), one));
}

TEST_CASE("Another seed gives another picture of the same scene") {
  const auto render_scene = build_render_scene(cluttered(), {});
  const Camera view = camera({0, 2.5, 14}, {0, 1, 0}, 40, 30, 75);
  const OIIO::ImageBuf a = render(*render_scene, view, {.samples = 64, .seed = 0});
  const OIIO::ImageBuf b = render(*render_scene, view, {.samples = 64, .seed = 1});
  CHECK_FALSE(same_bytes(a, b));
  CHECK((mean(a) / mean(b) - 1).abs().maxCoeff() < 0.02f);
}

TEST_CASE("Every number of samples fills every pixel") {
  const RenderScene scene(scene_of(material({1, 1, 1, 1}), quad({-1, -1, -9}, {0.1f, 0, 0}, {0, 0.1f, 0})),
                          constant_light(2));
  const Camera view = camera({0, 0, 0}, {0, 0, 1}, 19, 17, 60);  // sky alone
  for (int samples : {1, 2, 3, 5, 8, 11, 16}) {
    const OIIO::ImageBuf image = render(scene, view, {.samples = samples});
    for (int y = 0; y < 17; ++y) {
      for (int x = 0; x < 19; ++x) REQUIRE(pixel(image, x, y).x() == Approx(2));
    }
  }
}

TEST_CASE("Samples of a pixel are uniform over its square") {
  // A black half plane ends at nine tenths of the middle pixel: its box mean is 0.1.
  const Material black = material({0, 0, 0, 1}, 1, 1);
  const RenderScene scene(scene_of(black, quad({-10, -10, -1}, {10.4f, 0, 0}, {0, 20, 0})),
                          constant_light(1));
  Camera view;
  view.pinhole = {3, 3, 1, 1, 1, 1};
  view.world_from_camera.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const OIIO::ImageBuf image = render(scene, view, {.samples = 4096});
  CHECK(pixel(image, 1, 1).x() == Approx(0.1).margin(0.001));
  CHECK(pixel(image, 2, 1).x() == Approx(1));
  CHECK(pixel(image, 0, 1).x() == Approx(0).margin(0.003));
}
