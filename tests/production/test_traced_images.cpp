#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "dataset/dense/dense_file.h"
#include "dataset/pixels/image_file.h"
#include "numbers/srgb.h"
#include "production/dense_labels.h"
#include "renderer/paths/build_render_scene.h"
#include "tests/production/floor_and_sphere.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

/// Equidistant: a ray lands 14 px from the middle for each radian off the axis. The picture's corners lie
/// beyond the 180° (44 px) that there are.
const ModelCamera whole_sphere{"", {96, 60, 14, 14, 47.5, 29.5}, KannalaBrandt{}};
constexpr double focal_px = 14, rim_px = 14 * std::numbers::pi;

/// A view of images through the given cameras.
struct TracedView {
  TemporaryFolder folder = {};
  Recipe recipe = {};
  PlannedView view = {};
  ViewImages wanted = {};
  LitScene lit = {};

  TracedView(const std::vector<ModelCamera>& cameras, const std::shared_ptr<RenderScene>& scene) {
    recipe.samples = 2;
    view.camera.pitch_deg = -3;
    view.camera.roll_deg = 2;
    for (std::size_t i = 0; i < cameras.size(); ++i)
      wanted.images.push_back({.file = "group" + std::to_string(i) + "/000007.png",
                               .lens = {},
                               .sensor = make_stream(i, "sensor"),
                               .model = cameras[i]});
    lit.scene = scene;
  }

  OIIO::ImageBuf label(DenseLabel kind) const {
    return read_dense(folder.path / dense_file(wanted.images[0].file, kind), kind);
  }
};

/// A lamp of radiance 1 all around.
std::shared_ptr<RenderScene> inside_a_lamp() {
  Scene scene;
  scene.materials = {handmade::lamp({1, 1, 1})};
  scene.materials[0].double_sided = true;
  handmade::add(scene, handmade::sphere(60));
  return std::make_shared<RenderScene>(scene, handmade::no_light());
}

double radius_px(int x, int y) {
  return std::hypot(x - 47.5, y - 29.5);
}

}  // namespace

TEST_CASE(
    "traced images have the scene's light and one exposure and are black where the lens shows nothing") {
  ModelCamera narrow = whole_sphere;
  narrow.pinhole.fx = narrow.pinhole.fy = 30;
  TracedView traced({whole_sphere, narrow}, inside_a_lamp());
  traced.wanted.sensor = {0, 0, 1e9, 1e9, 0, 0};  // no noise to speak of
  const RenderedView rendered = render_view(traced.recipe, traced.view, traced.wanted, traced.lit);
  REQUIRE(rendered.traced.size() == 2);
  CHECK(rendered_pixels(traced.wanted) == 2 * 96 * 60);
  ImageTimes times;
  const MadeImages made = make_images(traced.wanted, rendered, traced.folder.path, times);
  CHECK(made.exposure == FrameExposure::good);
  CHECK(made.record.exposure == Approx(0.18).epsilon(1e-4));
  CHECK_FALSE(made.record.master);
  const auto grey = static_cast<int>(std::lround(255 * srgb_from_linear(0.18)));
  for (int i = 0; i < 2; ++i) {
    const OIIO::ImageBuf image = read_pixels(traced.folder.path / traced.wanted.images[i].file);
    const auto* code = static_cast<const std::uint8_t*>(image.localpixels());
    int valid = 0, black = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 96; ++x, code += 3) {
        const double farthest = std::hypot(std::abs(x - 47.5) + 1.5, std::abs(y - 29.5) + 1.5);
        const bool is_valid = i == 1 || farthest < rim_px;
        for (int c = 0; c < 3; ++c) CHECK(std::abs(code[c] - (is_valid ? grey : 0)) <= (is_valid ? 1 : 0));
        ++(is_valid ? valid : black);
      }
    CHECK(valid > 4000);
    CHECK((i == 1 ? black == 0 : black > 500));
  }
}

TEST_CASE("exposure is metered on the pixels that the lens shows") {
  // Of this upright picture, whose middle half reaches 60 px up and down, the lens shows a circle of 44 px.
  const ModelCamera upright{"", {60, 240, 14, 14, 29.5, 119.5}, KannalaBrandt{}};
  TracedView traced({upright}, inside_a_lamp());
  ImageTimes times;
  const RenderedView rendered = render_view(traced.recipe, traced.view, traced.wanted, traced.lit);
  CHECK(make_images(traced.wanted, rendered, traced.folder.path, times).record.exposure ==
        Approx(0.18).epsilon(1e-4));
}

TEST_CASE("images of one view share the exposure that is metered on all of them") {
  TracedView traced({whole_sphere, whole_sphere}, inside_a_lamp());
  RenderedView rendered;
  for (const float radiance : {0.1f, 0.4f}) {
    OIIO::ImageBuf light(OIIO::ImageSpec(96, 60, 3, OIIO::TypeDesc::FLOAT));
    std::fill_n(static_cast<float*>(light.localpixels()), 3 * 96 * 60, radiance);
    rendered.traced.push_back(std::move(light));
  }
  ImageTimes times;
  // Both count alike: their mean is brought to 18 % of white.
  CHECK(make_images(traced.wanted, rendered, traced.folder.path, times).record.exposure ==
        Approx(0.18 / 0.25).epsilon(1e-5));
}

TEST_CASE("every traced image has its own paths and the same each time") {
  const auto scene = build_render_scene(floor_and_sphere(), {});
  TracedView traced({whole_sphere, whole_sphere}, scene), again({whole_sphere, whole_sphere}, scene);
  const RenderedView a = render_view(traced.recipe, traced.view, traced.wanted, traced.lit),
                     b = render_view(again.recipe, again.view, again.wanted, again.lit);
  const std::size_t bytes = a.traced[0].spec().image_bytes();
  for (int i = 0; i < 2; ++i)
    CHECK(std::memcmp(a.traced[i].localpixels(), b.traced[i].localpixels(), bytes) == 0);
  CHECK(std::memcmp(a.traced[0].localpixels(), a.traced[1].localpixels(), bytes) != 0);
}

TEST_CASE(
    "dense labels of a floor and a sphere through a fisheye that sees all around are their closed forms") {
  const Scene scene = floor_and_sphere();
  TracedView traced({whole_sphere}, build_render_scene(scene, {}));
  for (std::size_t i = 0; i < dense_label_names.size(); ++i)
    traced.recipe.labels.push_back(static_cast<DenseLabel>(i));
  traced.lit.labels = instance_labels(scene, traced.recipe.labels);
  traced.lit.labels.semantic_background = 23;
  std::atomic<std::int64_t> cpu_ns = 0;
  make_dense_labels(traced.recipe, traced.view, traced.wanted, traced.lit, traced.folder.path, cpu_ns);

  const Eigen::Isometry3d world_from_camera =
      world_from_vehicle(traced.view.place) * vehicle_from_camera(traced.view.camera);
  const Eigen::Vector3d from = world_from_camera.translation(), center(7, 1.5, 0.5);
  const OIIO::ImageBuf depth = traced.label(DenseLabel::depth), distance = traced.label(DenseLabel::distance),
                       normal = traced.label(DenseLabel::normal), rays = traced.label(DenseLabel::rays),
                       instance = traced.label(DenseLabel::instance),
                       semantic = traced.label(DenseLabel::semantic),
                       latitude = traced.label(DenseLabel::latitude);
  const auto id = [](const OIIO::ImageBuf& image, int x, int y) {
    return *static_cast<const std::uint16_t*>(image.pixeladdr(x, y));
  };
  int on_floor = 0, on_sphere = 0, in_sky = 0, unseen = 0, behind = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 96; ++x) {
      const double angle = radius_px(x, y) / focal_px, around = std::atan2(y - 29.5, x - 47.5);
      if (std::abs(radius_px(x, y) - rim_px) < 0.01) continue;
      if (radius_px(x, y) > rim_px) {
        ++unseen;
        for (int c = 0; c < 3; ++c) CHECK(rays.getchannel(x, y, 0, c) == 0);
        CHECK(std::isinf(depth.getchannel(x, y, 0, 0)));
        CHECK(id(instance, x, y) == 0);
        CHECK(id(semantic, x, y) == 0);
        continue;
      }
      const Eigen::Vector3d in_camera(std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
                                      std::cos(angle));
      const Eigen::Vector3d ray = world_from_camera.linear() * in_camera;
      for (int c = 0; c < 3; ++c) CHECK(rays.getchannel(x, y, 0, c) == Approx(in_camera[c]).margin(1e-6));
      CHECK(latitude.getchannel(x, y, 0, 0) == Approx(degrees(std::asin(ray.y()))).margin(1e-4));
      const double along = (center - from).dot(ray), miss = (center - from - along * ray).norm();
      if (along > 0 && std::abs(miss - 1) < 3e-3) continue;  // the silhouette of a sphere made of triangles
      const double t = -from.y() / ray.y();
      if (along > 0 && miss < 1) {
        ++on_sphere;
        CHECK(id(instance, x, y) == 2);
        const double grazing = std::sqrt(1 - miss * miss);
        CHECK(distance.getchannel(x, y, 0, 0) ==
              Approx(along - grazing).margin(4e-5 / std::max(0.05, grazing)));
      } else if (t > 0 && (from + t * ray).cwiseAbs().maxCoeff() < 390) {
        ++on_floor;
        behind += in_camera.z() < 0;
        const double tolerance = 5e-6 * t * std::max(1.0, t / from.y());
        CHECK(distance.getchannel(x, y, 0, 0) == Approx(t).margin(tolerance));
        CHECK(depth.getchannel(x, y, 0, 0) == Approx(t * in_camera.z()).margin(tolerance));
        for (int c = 0; c < 3; ++c)
          CHECK(normal.getchannel(x, y, 0, c) == Approx(world_from_camera.linear()(1, c)).margin(3e-6));
        CHECK(id(instance, x, y) == 1);
        CHECK(id(semantic, x, y) == 1);
      } else if (ray.y() > 0) {
        ++in_sky;
        CHECK(std::isinf(distance.getchannel(x, y, 0, 0)));
        CHECK(id(instance, x, y) == 0);
        CHECK(id(semantic, x, y) == 23);
      }
    }
  CHECK(on_floor > 1000);
  CHECK(behind > 300);
  CHECK(on_sphere > 10);
  CHECK(in_sky > 1000);
  CHECK(unseen > 300);
}
