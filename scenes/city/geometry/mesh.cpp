#include "scenes/city/geometry/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps::city {

std::array<std::uint8_t, 4> gray_color(double light) {
  const auto x = static_cast<std::uint8_t>(std::clamp(light * 255.0 + 0.5, 0.0, 255.0));
  return {x, x, x, 255};
}

std::size_t Mesh::triangle_count() const {
  std::size_t count = 0;
  for (const auto& [material, surface] : surfaces) count += surface.indices.size() / 3;
  return count;
}

void add_polygon(Surface& surface, const std::vector<Vertex>& corners) {
  Vec3 twice_area = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    twice_area +=
        (corners[i - 1].position - corners[0].position).cross(corners[i].position - corners[0].position);
  if (twice_area.norm() < 1e-7) return;
  const Eigen::Vector3f normal = twice_area.normalized().cast<float>();
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  for (const Vertex& v : corners) {
    surface.positions.push_back(v.position.cast<float>());
    surface.normals.push_back(normal);
    surface.uvs.push_back(v.uv.cast<float>());
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i)
    surface.indices.insert(surface.indices.end(), {first, first + i - 1, first + i});
}

void add_box(Surface& surface, const Vec2& centre, const Vec2& along, double half_length, double half_width,
             double bottom, double top, double tile_m, bool with_bottom) {
  const Vec2 a = along * half_length, b = left_of(along) * half_width;
  const std::array<Vec2, 4> ring{centre - a - b, centre + a - b, centre + a + b, centre - a + b};
  for (int i = 0; i < 4; ++i) {
    const Vec2 &p = ring[i], &q = ring[(i + 1) % 4];
    const double l = (q - p).norm() / tile_m;
    add_quad(surface, {lift(p, bottom), {0, -bottom / tile_m}}, {lift(q, bottom), {l, -bottom / tile_m}},
             {lift(q, top), {l, -top / tile_m}}, {lift(p, top), {0, -top / tile_m}});
  }
  const double u = 2 * half_length / tile_m, v = 2 * half_width / tile_m;
  add_quad(surface, {lift(ring[0], top), {0, v}}, {lift(ring[1], top), {u, v}}, {lift(ring[2], top), {u, 0}},
           {lift(ring[3], top), {0, 0}});
  if (with_bottom)
    add_quad(surface, {lift(ring[3], bottom), {0, 0}}, {lift(ring[2], bottom), {u, 0}},
             {lift(ring[1], bottom), {u, v}}, {lift(ring[0], bottom), {0, v}});
}

void add_block(Surface& s, const Vec3& low, const Vec3& high, double tile_m) {
  const Vec2 centre((low.x() + high.x()) / 2, -(low.z() + high.z()) / 2);
  add_box(s, centre, {1, 0}, (high.x() - low.x()) / 2, (high.z() - low.z()) / 2, low.y(), high.y(), tile_m,
          true);
}

void add_floor(Surface& surface, const Polygon& polygon, double height, double tile_m) {
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  for (const Vec2& p : polygon) {
    surface.positions.push_back(lift(p, height).cast<float>());
    surface.normals.emplace_back(0.f, 1.f, 0.f);
    surface.uvs.emplace_back(Vec2(p.x() / tile_m, -p.y() / tile_m).cast<float>());
  }
  for (const auto& [a, b, c] : triangulate(polygon)) {
    if (std::abs(cross(polygon[b] - polygon[a], polygon[c] - polygon[a])) < 1e-9) continue;
    for (const int corner : {a, b, c}) surface.indices.push_back(first + corner);
  }
}

void add_tube(Surface& surface, const Vec3& from, const Vec3& to, double radius_from, double radius_to,
              int sides, bool capped, double tile_m) {
  const Vec3 axis = (to - from).normalized();
  const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
  const double rise = (to - from).norm();
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  const double around = std::max(1.0, std::round(2 * std::numbers::pi * radius_from / tile_m));
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const Vec3 spoke = x * std::cos(angle) + y * std::sin(angle);
    const Vec3 normal = (spoke * rise + axis * (radius_from - radius_to)).normalized();
    for (int end = 0; end < 2; ++end) {
      const Vec3 p = (end ? to : from) + spoke * (end ? radius_to : radius_from);
      surface.positions.push_back(p.cast<float>());
      surface.normals.push_back(normal.cast<float>());
      surface.uvs.emplace_back(Vec2(around * i / sides, end ? -rise / tile_m : 0).cast<float>());
    }
  }
  for (int i = 0; i < sides; ++i) {
    const std::uint32_t a = first + 2 * i;
    surface.indices.insert(surface.indices.end(), {a, a + 2, a + 3});
    if (radius_to > 1e-4) surface.indices.insert(surface.indices.end(), {a, a + 3, a + 1});
  }
  if (!capped) return;
  std::vector<Vertex> cap(sides);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const Vec3 spoke = (x * std::cos(angle) + y * std::sin(angle)) * radius_to;
    cap[i] = {to + spoke, Vec2(spoke.dot(x), spoke.dot(y)) / tile_m};
  }
  add_polygon(surface, cap);
}

}  // namespace cps::city
