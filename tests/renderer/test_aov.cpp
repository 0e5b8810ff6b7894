#include <catch2/catch.hpp>
#include <map>

#include "renderer/aov.h"
#include "renderer/camera_path.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

std::map<Aov, OIIO::ImageBuf> all_aovs(const RenderScene& scene, const Camera& camera, int samples = 16) {
  std::vector<Aov> wanted;
  for (const std::string& name : aov_names()) wanted.push_back(aov_from_string(name));
  std::vector<ImageLayer> layers = render_aovs(scene, camera, {.samples = samples}, wanted);
  std::map<Aov, OIIO::ImageBuf> result;
  for (std::size_t i = 0; i < wanted.size(); ++i) result[wanted[i]] = layers[i].image;
  return result;
}

double value(const OIIO::ImageBuf& image, int x, int y) {
  return image.getchannel(x, y, 0, 0);
}

std::uint32_t id(const OIIO::ImageBuf& image, int x, int y) {
  return *static_cast<const std::uint32_t*>(image.pixeladdr(x, y));
}

/// A red floor at y = 0, a blue sphere of radius 1 above it, nothing behind.
Scene floor_and_sphere() {
  Scene scene;
  scene.materials = {material({0.8f, 0.1f, 0.1f, 1}), material({0.1f, 0.2f, 0.9f, 1})};
  add(scene, quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}));
  add(scene, sphere(1, 1, 256), Eigen::Affine3f(Eigen::Translation3f(0, 2, 0)));
  return scene;
}

}  // namespace

TEST_CASE("Layers of a floor and a sphere, through a lens, against their closed forms") {
  const RenderScene scene(floor_and_sphere(), constant_light(1));
  Camera view = camera({0.5, 2.2, 5}, {0, 1.4, 0}, 61, 47, 95);
  view.lens = Distortion{-0.08, 0.01, 0, 0.004, -0.003};
  auto aovs = all_aovs(scene, view);
  const CameraRays rays = make_camera_rays(view, PixelFilter::box);
  const Eigen::Vector3d from = view.world_from_camera.translation(),
                        axis = view.world_from_camera.linear().col(2);
  int on_floor = 0, on_sphere = 0, nothing = 0;
  for (int y = 0; y < 47; ++y) {
    for (int x = 0; x < 61; ++x) {
      const Eigen::Vector3d d =
          camera_ray(rays, camera_pixel(rays, x, y), Eigen::Vector2f::Zero()).direction.cast<double>();
      const Eigen::Vector3d to_center = Eigen::Vector3d(0, 2, 0) - from;
      const double along = to_center.dot(d), miss = (to_center - along * d).norm();
      if (std::abs(miss - 1) < 2e-3) continue;  // the silhouette of a sphere made of triangles
      double t = std::numeric_limits<double>::infinity();
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      if (miss < 1) {
        t = along - std::sqrt(1 - miss * miss);
        normal = from + t * d - Eigen::Vector3d(0, 2, 0);
        ++on_sphere;
        CHECK(id(aovs[Aov::instance], x, y) == 2);
        CHECK(id(aovs[Aov::material], x, y) == 2);
      } else if (const double floor = -from.y() / d.y();
                 floor > 0 && (from + floor * d).cwiseAbs().maxCoeff() < 49) {
        t = floor;
        normal = Eigen::Vector3d::UnitY();
        ++on_floor;
        CHECK(id(aovs[Aov::instance], x, y) == 1);
        CHECK(id(aovs[Aov::material], x, y) == 1);
      } else if (d.y() > 0) {
        ++nothing;
        CHECK(id(aovs[Aov::instance], x, y) == 0);
        CHECK(id(aovs[Aov::material], x, y) == 0);
        CHECK(std::isinf(value(aovs[Aov::distance], x, y)));
        CHECK(std::isinf(value(aovs[Aov::depth], x, y)));
        continue;
      } else {
        continue;
      }
      // The sphere's facets lie up to 1 − cos(π/512) inside it, more for rays that graze it.
      const double slack = miss < 1 ? 4e-5 / std::max(0.05, -normal.dot(d)) : 1e-5 * t;
      CHECK(value(aovs[Aov::distance], x, y) == Approx(t).margin(slack));
      CHECK(value(aovs[Aov::depth], x, y) == Approx(t * d.dot(axis)).margin(slack));
      for (int c = 0; c < 3; ++c) {
        CHECK(aovs[Aov::position].getchannel(x, y, 0, c) == Approx((from + t * d)[c]).margin(slack + 1e-5));
        CHECK(aovs[Aov::normal].getchannel(x, y, 0, c) == Approx(normal[c]).margin(0.02));
      }
    }
  }
  CHECK(on_floor > 500);
  CHECK(on_sphere > 60);
  CHECK(nothing > 500);
}

TEST_CASE("Albedo is averaged over the pixel, ids are not") {
  // Left half of the middle pixel red, right half blue: the border passes a little right of its centre.
  Scene scene;
  scene.materials = {material({1, 0, 0, 1}), material({0, 0, 1, 1})};
  add(scene, quad({-10, -10, -1}, {10.1f, 0, 0}, {0, 20, 0}, 0));
  add(scene, quad({0.1f, -10, -1}, {10, 0, 0}, {0, 20, 0}, 1));
  Camera view;
  view.pinhole = {3, 3, 1, 1, 1, 1};
  view.world_from_camera.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  auto aovs = all_aovs(RenderScene(scene, constant_light(1)), view, 64);
  CHECK(id(aovs[Aov::material], 1, 1) == 1);
  CHECK(id(aovs[Aov::material], 2, 1) == 2);
  CHECK(aovs[Aov::albedo].getchannel(1, 1, 0, 0) == Approx(0.6).margin(1.0 / 16));
  CHECK(aovs[Aov::albedo].getchannel(1, 1, 0, 2) == Approx(0.4).margin(1.0 / 16));
}

TEST_CASE("Central rays do not slip through an edge that runs through pixels' centres") {
  Camera view;
  view.pinhole = {64, 64, 31, 31, 32, 32};  // the quad's diagonal passes the centres of the picture's
  view.world_from_camera.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  for (int turn = 0; turn < 40; ++turn) {
    const Eigen::Isometry3d placed = Eigen::Translation3d(3.1 * turn, 1.7, -2.3 * turn) *
                                     Eigen::AngleAxisd(0.37 * turn, Eigen::Vector3d(1, 2, 3).normalized());
    const float depth = 1.0f + static_cast<float>(turn);
    Scene scene;
    scene.materials = {material({1, 1, 1, 1})};
    Mesh mesh = quad({-2 * depth, -2 * depth, -depth}, {4 * depth, 0, 0}, {0, 4 * depth, 0});
    mesh.triangles = {{0, 1, 3}, {1, 2, 3}};
    add(scene, mesh, Eigen::Affine3f(placed.cast<float>()));
    Camera camera = view;
    camera.world_from_camera = placed * view.world_from_camera;
    auto aovs = all_aovs(RenderScene(scene, constant_light(1)), camera, 1);
    for (int i = 0; i < 64; ++i) {
      CHECK(id(aovs[Aov::material], i, i) == 1);
      CHECK(id(aovs[Aov::material], i, 63 - i) == 1);
    }
  }
}

TEST_CASE("Names of layers are checked") {
  CHECK(aov_from_string("depth") == Aov::depth);
  CHECK_THROWS_WITH(aov_from_string("dept"), Catch::Contains("dept") && Catch::Contains("material"));
}
