#include <catch2/catch.hpp>

#include "random/counter_hash.h"
#include "renderer/aov.h"
#include "renderer/camera_mask.h"
#include "renderer/camera_rays.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

/// A camera at the origin that looks along world −z through a fisheye with this focal length.
Camera fisheye(const LensModel& lens, int width, int height, double focal) {
  Camera c = camera({0, 0, 0}, {0, 0, -1}, width, height, 90);
  c.pinhole.fx = c.pinhole.fy = focal;
  c.lens = lens;
  return c;
}

/// The direction in the camera's frame that a picture position sees.
Eigen::Vector3d seen_from(const Camera& camera, const CameraRays& rays, const Eigen::Vector2d& position) {
  const int x = static_cast<int>(std::floor(position.x())), y = static_cast<int>(std::floor(position.y()));
  const Eigen::Vector2f offset = (position - Eigen::Vector2d(x, y)).cast<float>();
  const CameraRay ray = camera_ray(rays, camera_pixel(rays, x, y), offset);
  REQUIRE(ray.is_seen);
  return camera.world_from_camera.linear().transpose() * ray.direction.cast<double>();
}

/// A family's point of the normalised image by its formula on a unit ray, as published.
struct Formula {
  LensModel lens;
  Eigen::Vector2d (*point)(const Eigen::Vector3d& ray);
};

/// The focal length, pixels, with which a ray `angle_deg` off the axis lands `radius_px` from the middle.
double focal_for(const Formula& formula, double angle_deg, double radius_px) {
  const double angle = radians(angle_deg);
  return radius_px / formula.point({std::sin(angle), 0, std::cos(angle)}).norm();
}

const Formula formulas[] = {
    {KannalaBrandt{-0.03, 0.004, 0, 0},
     [](const Eigen::Vector3d& d) -> Eigen::Vector2d {
       const double r = d.head<2>().norm(), t = std::atan2(r, d.z());
       return d.head<2>() / r * (t - 0.03 * t * t * t + 0.004 * t * t * t * t * t);
     }},
    {UnifiedSpherical{0.9, {}},
     [](const Eigen::Vector3d& d) -> Eigen::Vector2d { return d.head<2>() / (d.z() + 0.9); }},
    {Eucm{0.6, 1.1},
     [](const Eigen::Vector3d& d) -> Eigen::Vector2d {
       return d.head<2>() / (0.6 * std::sqrt(1.1 * d.head<2>().squaredNorm() + d.z() * d.z()) + 0.4 * d.z());
     }},
    {DoubleSphere{-0.2, 0.55}, [](const Eigen::Vector3d& d) -> Eigen::Vector2d {
       const double z = d.z() - 0.2;
       return d.head<2>() / (0.55 * std::sqrt(d.head<2>().squaredNorm() + z * z) + 0.45 * z);
     }}};

}  // namespace

TEST_CASE(
    "Through an equidistant fisheye, the distance from the principal point is the angle from the axis") {
  const Camera c = fisheye(KannalaBrandt{}, 300, 200, 95);  // corners at 109°
  const CameraRays rays = make_camera_rays(c, PixelFilter::box);
  for (const double radius : {0.0, 0.3, 20.0, 90.0, 148.0})
    for (const double azimuth : {0.0, 0.7, 2.5, 4.0}) {
      const Eigen::Vector2d from_centre = radius * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
      if (std::abs(from_centre.y()) > 99) continue;
      const Eigen::Vector3d d = seen_from(c, rays, from_centre + Eigen::Vector2d(c.pinhole.cx, c.pinhole.cy));
      const double angle = radius / 95;
      CHECK((d - Eigen::Vector3d(std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
                                 std::cos(angle)))
                .norm() < 1e-6);
    }
}

TEST_CASE("Each family's rays meet the picture where its published formula says, beyond 90 degrees too") {
  const Stream stream = make_stream(4, "model rays");
  for (const Formula& formula : formulas) {
    const Camera c = fisheye(formula.lens, 240, 180, focal_for(formula, 110, 150));  // in the corners
    const CameraRays rays = make_camera_rays(c, PixelFilter::box);
    double widest = 0;
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector2d at(random_uniform(stream, 2 * i, -.5, 239.5),
                               random_uniform(stream, 2 * i + 1, -.5, 179.5));
      const Eigen::Vector3d d = seen_from(c, rays, at);
      widest = std::max(widest, std::atan2(d.head<2>().norm(), d.z()));
      // Directions are floats.
      CHECK((to_pixel(c.pinhole, formula.point(d)) - at).norm() < 1e-3);
    }
    CHECK(widest > radians(90));
  }
}

TEST_CASE("A fisheye ray's pixel angle is the root of the solid angle of its pixel") {
  // Equidistant: a pixel covers (1/f) × (sin θ / (θ f)).
  const Camera c = fisheye(KannalaBrandt{}, 300, 200, 95);
  const CameraRays rays = make_camera_rays(c, PixelFilter::box);
  for (const auto& [x, y] : {std::pair(149, 100), std::pair(0, 0), std::pair(290, 40)}) {
    const double angle = std::hypot(x - 149.5, y - 99.5) / 95;
    const float found = camera_ray(rays, camera_pixel(rays, x, y), Eigen::Vector2f::Zero()).pixel_angle;
    CHECK(found == Approx(std::sqrt(std::sin(angle) / angle) / 95).epsilon(1e-5));
  }
}

TEST_CASE("A lamp behind the camera is seen where the fisheye's formula says") {
  const Eigen::Vector3d towards = Eigen::Vector3d(
      std::sin(radians(115)) * std::cos(0.6), std::sin(radians(115)) * std::sin(0.6), std::cos(radians(115)));
  for (const Formula& formula : formulas) {
    const Camera c = fisheye(formula.lens, 240, 240, focal_for(formula, 115, 100));
    const Eigen::Vector3d place = 6 * (c.world_from_camera.linear() * towards);
    Scene scene;
    scene.materials = {lamp({1, 1, 1})};
    add(scene, sphere(0.15f), Eigen::Affine3f(Eigen::Translation3f(place.cast<float>())));
    const OIIO::ImageBuf image = render(RenderScene(scene, no_light()), c, {.samples = 64});
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double light = 0;
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 240; ++x) {
        const double value = pixel(image, x, y).y();
        light += value;
        centre += value * Eigen::Vector2d(x, y);
      }
    REQUIRE(light > 1);
    // The lamp is 3° wide: its middle is not quite the middle of its picture.
    CHECK((centre / light - to_pixel(c.pinhole, formula.point(towards))).norm() < 0.15);
  }
}

TEST_CASE("What a circular fisheye does not show is black, infinitely far and not valid") {
  // Equidistant with f = 10: the circle of 180° off the axis has radius 31.4.
  const Camera c = fisheye(KannalaBrandt{}, 80, 80, 10);
  Scene scene;
  scene.materials = {lamp({1, 1, 1})};
  scene.materials[0].double_sided = true;
  add(scene, sphere(5));
  const RenderScene ready(scene, no_light());
  const OIIO::ImageBuf image = render(ready, c, {.samples = 4}), mask = seen_pixels(c);
  const OIIO::ImageBuf depth = render_aovs(ready, c, {.samples = 4}, {Aov::depth}).front().image;
  const double rim = 10 * std::numbers::pi;
  int seen = 0, unseen = 0;
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 80; ++x) {
      const double dx = std::abs(x - 39.5), dy = std::abs(y - 39.5);
      const double nearest = std::hypot(std::max(dx - .5, 0.0), std::max(dy - .5, 0.0)),
                   farthest = std::hypot(dx + .5, dy + .5);
      const bool is_valid = mask.getchannel(x, y, 0, 0) > 0;
      if (farthest < rim - 1e-3) {
        ++seen;
        CHECK(is_valid);
        CHECK((pixel(image, x, y) > 0.9f).all());
        CHECK(std::isfinite(depth.getchannel(x, y, 0, 0)));
      } else if (nearest > rim + 1e-3) {
        ++unseen;
        CHECK_FALSE(is_valid);
        CHECK((pixel(image, x, y) == 0).all());
        CHECK(std::isinf(depth.getchannel(x, y, 0, 0)));
      } else {
        CHECK_FALSE(is_valid);
      }
    }
  CHECK(seen > 2800);
  CHECK(unseen > 2800);
}

TEST_CASE("Depth through a fisheye is along the axis, negative behind it") {
  const Camera c = fisheye(KannalaBrandt{}, 60, 60, 12);  // 143° at the edge's middle
  Scene scene;
  scene.materials = {lambert({1, 1, 1, 1})};
  scene.materials[0].double_sided = true;
  add(scene, sphere(5, 0, 128));
  const std::vector<ImageLayer> layers =
      render_aovs(RenderScene(scene, constant_light(1)), c, {.samples = 1}, {Aov::depth, Aov::distance});
  for (int x = 0; x < 60; ++x) {
    const double angle = std::hypot(x - 29.5, 0.5) / 12;
    CHECK(layers[0].image.getchannel(x, 29, 0, 0) == Approx(5 * std::cos(angle)).margin(5e-3));
    CHECK(layers[1].image.getchannel(x, 29, 0, 0) == Approx(5).margin(5e-3));
  }
}

TEST_CASE("A rational lens that folds in the picture is refused as a Brown-Conrady lens is") {
  Camera c = fisheye(RationalLens{.k1 = -0.4}, 640, 480, 320);
  CHECK_THROWS_WITH(make_camera_rays(c, PixelFilter::box),
                    Catch::StartsWith("lens: not one-to-one on the picture: "));
  c.lens = RationalLens{.k1 = -0.05};
  CHECK_NOTHROW(make_camera_rays(c, PixelFilter::box));
}
