#include "tests/leak/noise_wall.h"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "numbers/angles.h"
#include "renderer/render.h"

namespace cps {
namespace {

/// A square far wider than what the camera sees of it, ten metres away.
Scene wall_scene() {
  Scene scene;
  Material plaster;
  plaster.name = "plaster";
  plaster.base_color = {0.6f, 0.55f, 0.5f, 1};
  plaster.metallic = 0;
  plaster.specular = 0;
  scene.materials = {plaster};
  Mesh mesh;
  constexpr float half = 100;
  mesh.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uv0.assign(4, {0, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes = {mesh};
  scene.instances.resize(1);
  for (const Eigen::Vector3f& corner : mesh.positions) scene.bounds.extend(corner);
  return scene;
}

OIIO::ImageBuf cut(const OIIO::ImageBuf& from, int x0, int y0, int width, int height, bool mirror,
                   bool flip) {
  OIIO::ImageBuf image(OIIO::ImageSpec(width, height, 3, OIIO::TypeFloat));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      std::memcpy(image.pixeladdr(x, y),
                  from.pixeladdr(x0 + (mirror ? width - 1 - x : x), y0 + (flip ? height - 1 - y : y)),
                  3 * sizeof(float));
  return image;
}

}  // namespace

NoiseWall render_noise_wall(WallLight light, int samples, int side_px, std::uint64_t seed) {
  Daylight daylight{.sun_elevation_deg = 35, .sun_azimuth_deg = 150};
  if (light == WallLight::shade) daylight.sun_irradiance_klx = Eigen::Vector3f::Zero();
  const auto scene = build_render_scene(wall_scene(), daylight);
  Camera camera{.pinhole = pinhole_from_hfov(side_px, side_px, radians(40))};
  camera.world_from_camera =
      Eigen::Translation3d(0, 0, 10) * Eigen::AngleAxisd(std::acos(-1.0), Eigen::Vector3d::UnitX());
  const auto half = [&](const char* name) {
    return render(*scene, camera, {.samples = samples / 2, .seed = make_stream(seed, name).key});
  };
  return {join_halves(half("first half"), half("second half"))};
}

NoisyMaster cut_master(const NoiseWall& wall, int width, int height, Stream stream) {
  const OIIO::ImageSpec& spec = wall.master.picture.spec();
  if (width > spec.width || height > spec.height)
    throw std::runtime_error("the wall is smaller than the master");
  const int x0 = int(random_uniform(stream, 0) * (spec.width - width + 1)),
            y0 = int(random_uniform(stream, 1) * (spec.height - height + 1));
  const bool mirror = random_uniform(stream, 2) < 0.5, flip = random_uniform(stream, 3) < 0.5;
  return {.picture = cut(wall.master.picture, x0, y0, width, height, mirror, flip),
          .noise = cut(wall.master.noise, x0, y0, width, height, mirror, flip)};
}

double relative_noise(const NoiseWall& wall) {
  const OIIO::ImageBuf& picture = wall.master.picture;
  const OIIO::ImageSpec& spec = picture.spec();
  double sum = 0, squares = 0;
  for (int y = 0; y < spec.height; ++y)
    for (int x = 0; x < spec.width; ++x) {
      const double value = picture.getchannel(x, y, 0, 1);
      sum += value;
      squares += value * value;
    }
  const double count = double(spec.width) * spec.height, average = sum / count;
  return std::sqrt(squares / count - average * average) / average;
}

}  // namespace cps
