#pragma once

#include <cmath>
#include <numbers>

#include "numbers/angles.h"
#include "renderer/paths/render_scene.h"
#include "renderer/render.h"

/// Small scenes and light for tests.
namespace cps::handmade {

inline Material material(const Eigen::Vector4f& base_color, float metallic = 0, float roughness = 1) {
  Material m;
  m.name = "handmade";
  m.base_color = base_color;
  m.metallic = metallic;
  m.roughness = roughness;
  return m;
}

/// Lambert's surface: no layer reflects above it.
inline Material lambert(const Eigen::Vector4f& base_color) {
  Material m = material(base_color);
  m.specular = 0;
  return m;
}

inline Material glass(const Eigen::Vector4f& tint) {
  Material m = material(tint, 0, 0);
  m.transmission = 1;
  m.double_sided = true;
  return m;
}

inline Material lamp(const Vec3& radiance) {
  Material m = lambert({0, 0, 0, 1});
  m.emissive = radiance;
  return m;
}

/// A parallelogram from `corner` along `a` (texture u) and `b` (texture −v); its front sees a × b.
inline Mesh quad(const Vec3& corner, const Vec3& a, const Vec3& b, int material = 0) {
  Mesh m;
  m.name = "quad";
  m.material = material;
  m.positions = {corner, corner + a, corner + a + b, corner + b};
  m.normals.assign(4, a.cross(b).normalized());
  m.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  Eigen::Vector4f tangent;
  tangent << a.normalized(), 1;
  m.tangents.assign(4, tangent);
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  return m;
}

inline Mesh sphere(float radius, int material = 0, int rings = 64) {
  Mesh m;
  m.name = "sphere";
  m.material = material;
  const int columns = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j <= columns; ++j) {
      const double t = std::numbers::pi * i / rings, p = 2 * std::numbers::pi * j / columns;
      const Vec3 direction =
          Eigen::Vector3d(std::sin(t) * std::cos(p), std::cos(t), -std::sin(t) * std::sin(p)).cast<float>();
      m.positions.push_back(radius * direction);
      m.normals.push_back(direction);
      m.uv0.emplace_back(static_cast<float>(j) / columns, static_cast<float>(i) / rings);
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int a = i * (columns + 1) + j, b = a + columns + 1;
      if (i + 1 < rings) m.triangles.emplace_back(a, b, b + 1);
      if (i > 0) m.triangles.emplace_back(a, b + 1, a + 1);
    }
  }
  return m;
}

inline void add(Scene& scene, const Mesh& mesh,
                const Eigen::Affine3f& transform = Eigen::Affine3f::Identity()) {
  scene.meshes.push_back(mesh);
  scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, transform});
}

inline Scene scene_of(const Material& material, const Mesh& mesh) {
  Scene scene;
  scene.materials.push_back(material);
  add(scene, mesh);
  return scene;
}

inline SkyAndSun constant_light(float radiance) {
  return {make_constant_sky(Color::Constant(radiance)), make_sun({0, 1, 0}, 0.01, Color::Zero())};
}

inline SkyAndSun no_light() {
  return constant_light(0);
}

inline SkyAndSun sun_only(const Vec3& direction, const Color& irradiance, double diameter_rad = 0.00925) {
  return {make_constant_sky(Color::Zero()), make_sun(direction.normalized(), diameter_rad, irradiance)};
}

/// At `from`, looking at `at` (not straight up or down).
inline Camera camera(const Eigen::Vector3d& from, const Eigen::Vector3d& at, int width, int height,
                     double hfov_deg) {
  Camera c;
  c.pinhole = pinhole_from_hfov(width, height, radians(hfov_deg));
  const Eigen::Vector3d forward = (at - from).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitY()).normalized();
  c.world_from_camera.linear() << right, forward.cross(right), forward;
  c.world_from_camera.translation() = from;
  return c;
}

inline Color pixel(const OIIO::ImageBuf& image, int x, int y) {
  const auto* p = static_cast<const float*>(image.localpixels()) + 3 * (y * image.spec().width + x);
  return {p[0], p[1], p[2]};
}

inline Color mean(const OIIO::ImageBuf& image) {
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (int y = 0; y < image.spec().height; ++y) {
    for (int x = 0; x < image.spec().width; ++x) sum += pixel(image, x, y).cast<double>();
  }
  return (sum / (image.spec().width * image.spec().height)).cast<float>();
}

}  // namespace cps::handmade
