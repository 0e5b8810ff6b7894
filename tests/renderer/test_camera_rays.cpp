#include <catch2/catch.hpp>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/crop/crop.h"
#include "distortion/warp/master_camera.h"
#include "distortion/warp/warp.h"
#include "numbers/angles.h"
#include "renderer/camera_rays.h"
#include "renderer/image_error.h"
#include "tests/distortion/random_lens.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

/// Pixel in which a world direction is seen.
Eigen::Vector2d seen_at(const Camera& camera, const Vec3& direction) {
  const Eigen::Vector3d d = camera.world_from_camera.linear().transpose() * direction.cast<double>();
  return to_pixel(camera.pinhole, distort(std::get<Distortion>(*camera.lens), d.head<2>() / d.z()));
}

/// Solid angle of the quadrilateral between four unit vectors, by two triangles (Van Oosterom & Strackee
/// 1983).
double solid_angle(const Eigen::Vector3d (&corner)[4]) {
  const auto triangle = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return 2 * std::atan2(std::abs(a.dot(b.cross(c))), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  };
  return triangle(corner[0], corner[1], corner[2]) + triangle(corner[0], corner[2], corner[3]);
}

/// A wall with fine and coarse structure, all of it larger than the master's pixels.
Scene painted_wall() {
  Scene scene;
  Texture t;
  t.name = "painting";
  t.width = t.height = 256;
  const Stream stream = make_stream(3, "painting");
  for (int y = 0; y < t.height; ++y)
    for (int x = 0; x < t.width; ++x)
      for (int c = 0; c < 4; ++c)
        t.rgba.push_back(
            c == 3 ? 255
                   : static_cast<std::uint8_t>(64 + random_below(stream, (y / 4 * 64 + x / 4) * 3 + c, 192)));
  scene.textures.push_back(t);
  scene.materials = {material({0, 0, 0, 1})};
  scene.materials[0].emissive = {1, 1, 1};  // light without noise
  scene.materials[0].emissive_texture.texture = 0;
  add(scene, quad({-8, -4, -4}, {16, 0, 0}, {0, 8, 0}));
  return scene;
}

}  // namespace

TEST_CASE("Each ray goes back through the lens to the point of the picture that it came from") {
  const Stream stream = make_stream(11, "camera rays");
  int tried = 0;
  for (int i = 0; tried < 40; ++i) {
    Camera camera = handmade::camera({3, 2, 1}, {7, 1, -5}, 1, 1, 60);
    camera.pinhole = random_camera(stream, i);
    const Distortion lens = random_lens(stream, i, camera.pinhole);
    if (!certify_frame(lens, oversampled(camera.pinhole, 1, 1), one_to_one).valid()) continue;
    camera.lens = lens;
    ++tried;
    const CameraRays rays = make_camera_rays(camera, PixelFilter::gaussian);
    const Stream s = substream(stream, i);
    for (int k = 0; k < 50; ++k) {
      const int x = static_cast<int>(random_below(s, 4 * k, camera.pinhole.width)),
                y = static_cast<int>(random_below(s, 4 * k + 1, camera.pinhole.height));
      const Eigen::Vector2f offset(static_cast<float>(random_uniform(s, 4 * k + 2, -1.5, 1.5)),
                                   static_cast<float>(random_uniform(s, 4 * k + 3, -1.5, 1.5)));
      const CameraRay ray = camera_ray(rays, camera_pixel(rays, x, y), offset);
      REQUIRE(ray.direction.norm() == Approx(1).margin(1e-6));
      const Eigen::Vector2d back = seen_at(camera, ray.direction);
      // Directions are floats: 1e-7 rad, seen from the rim of a wide picture.
      REQUIRE((back - Eigen::Vector2d(x, y) - offset.cast<double>()).norm() < 2e-3);
    }
  }
}

TEST_CASE("A ray's pixel angle is the root of the solid angle between its pixel's corners") {
  for (const std::optional<Distortion>& lens :
       {std::optional<Distortion>(), std::optional<Distortion>({-0.004, 0.0001, 0, 0.0004, -0.0007}),
        std::optional<Distortion>({0.006, 0, 0, 0, 0})}) {
    Camera camera;
    camera.pinhole = pinhole_from_hfov(640, 480, radians(150));
    camera.lens = lens;
    const CameraRays rays = make_camera_rays(camera, PixelFilter::box);
    for (const auto& [x, y] :
         {std::pair(320, 240), std::pair(0, 0), std::pair(639, 200), std::pair(90, 400)}) {
      const CameraPixel pixel = camera_pixel(rays, x, y);
      const auto corner = [&](float dx, float dy) -> Eigen::Vector3d {
        return camera_ray(rays, pixel, {dx, dy}).direction.cast<double>().normalized();
      };
      // Half a pixel is too small for float directions where the picture is widest: one pixel each way.
      const Eigen::Vector3d corners[4] = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
      const float angle = camera_ray(rays, pixel, Eigen::Vector2f::Zero()).pixel_angle;
      CHECK(angle * angle == Approx(solid_angle(corners) / 4).epsilon(0.02));
    }
  }
}

TEST_CASE("A lens that folds in the picture is refused with the certificate's reason") {
  Camera camera;
  camera.pinhole = pinhole_from_hfov(640, 480, radians(90));
  camera.lens = Distortion{-0.4, 0, 0, 0, 0};
  CHECK_THROWS_WITH(make_camera_rays(camera, PixelFilter::box),
                    Catch::StartsWith("lens: not one-to-one on the picture: ") && Catch::Contains("k1"));
}

TEST_CASE("Filters have the moments of their definitions") {
  const auto moments = [](PixelFilter filter) {
    Eigen::Array2d mean = Eigen::Array2d::Zero(), square = Eigen::Array2d::Zero();
    constexpr int n = 512;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Eigen::Array2d at =
            sample_filter(filter, {(static_cast<float>(i) + 0.5f) / n, (static_cast<float>(j) + 0.5f) / n})
                .cast<double>();
        CHECK(at.abs().maxCoeff() <= filter_radius_px(filter));
        mean += at;
        square += at.square();
      }
    CHECK((mean / (n * n)).abs().maxCoeff() < 1e-3);
    return Eigen::Array2d(square / (n * n));
  };
  for (int axis = 0; axis < 2; ++axis) {
    CHECK(moments(PixelFilter::box)[axis] == Approx(1.0 / 12).epsilon(1e-3));
    CHECK(moments(PixelFilter::tent)[axis] == Approx(1.0 / 6).epsilon(1e-3));
    // Of a round Gaussian cut off at q sigma: sigma² (1 − q²/2 · e / (1 − e)), e = exp(−q²/2).
    const double e = std::exp(-4.5), cut = 1 - 4.5 * e / (1 - e);
    CHECK(moments(PixelFilter::gaussian)[axis] == Approx(0.25 * cut).epsilon(3e-3));
  }
}

TEST_CASE("A picture through the lens equals the warp of a master") {
  const RenderScene scene(painted_wall(), constant_light(0));
  const Pinhole base = pinhole_from_hfov(160, 90, radians(75));
  const Distortion lens{-0.12, 0.02, 0, 0.003, -0.002};
  Camera through = handmade::camera({0, 0, 0}, {0.2, 0.1, -1}, 160, 90, 75);
  const Camera master{.world_from_camera = through.world_from_camera,
                      .pinhole = master_camera(base, WarpOptions{}, 0.4)};
  const Crop crop = border_free_crop(lens, base, {base.cx, base.cy});
  REQUIRE(crop.valid);
  through.pinhole = crop.camera;
  through.lens = lens;
  const OIIO::ImageBuf warped =
      warp(render(scene, master, {.samples = 64}), master.pinhole, lens, crop.camera);
  // The warp's kernel has a standard deviation of half a pixel, and so has the Gaussian filter.
  const OIIO::ImageBuf traced = render(scene, through, {.samples = 256, .filter = PixelFilter::gaussian});
  const double rmse = image_error(warped, traced).rmse;
  const double white = mean(traced).mean();
  INFO(20 * std::log10(white / rmse) << " dB");
  CHECK(20 * std::log10(white / rmse) > 40);

  Camera wrong = through;
  std::get<Distortion>(*wrong.lens).k1 += 0.01;
  CHECK(20 * std::log10(white / image_error(warped, render(scene, wrong, {.samples = 64})).rmse) < 34);
}
