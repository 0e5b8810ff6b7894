#include "renderer/geometry/texture_footprint.h"

#include <algorithm>
#include <cmath>

#include "renderer/math/fast_math.h"

namespace cps {
namespace {

/// Ratio of length to width up to which one texture lookup covers a footprint. It then reaches √8 widths to
/// the side: less than a pixel where a pixel has 16 rays or more.
constexpr float max_elongation_of_a_tap = 8.0f;
constexpr int max_taps = 8;

/// A step in the triangle's plane, in barycentric (u, v).
Eigen::Vector2f barycentric_step(const WorldTriangle& t, const Vec3& step) {
  const Vec3 ab = t.positions[1] - t.positions[0], ac = t.positions[2] - t.positions[0];
  const Vec3 normal = ab.cross(ac);
  return Eigen::Vector2f(step.cross(ac).dot(normal), ab.cross(step).dot(normal)) / normal.squaredNorm();
}

}  // namespace

TextureFootprint texture_footprint(const WorldTriangle& t, const Hit& hit, const Ray& ray, float width,
                                   float cosine) {
  TextureFootprint footprint;
  const float world_area = t.normal.norm();
  const float elongation = 1.0f / std::max(cosine, 1e-3f);
  if (ray.from_viewer && world_area > 0.0f)
    footprint.taps = std::clamp(static_cast<int>(elongation / max_elongation_of_a_tap + 0.5f), 1, max_taps);
  const float tap_area = width * width * elongation / static_cast<float>(footprint.taps);
  Eigen::Vector2f step = Eigen::Vector2f::Zero();
  if (footprint.taps > 1) {
    const Vec3 away = ray.direction - t.normal * (t.normal.dot(ray.direction) / (world_area * world_area));
    step = barycentric_step(t, away.normalized() * (width * elongation / static_cast<float>(footprint.taps)));
  }
  const int sets = t.geometry.uv1.empty() ? 1 : 2;
  for (int set = 0; set < sets; ++set) {
    const TriangleUv uv = t.geometry.corner_uv(hit.triangle, set);
    footprint.uv[set] = uv.at(hit.u, hit.v);
    const float squared = tap_area * uv.double_area() / world_area;
    footprint.log2_width[set] = 0.5f * log2_of(std::clamp(squared, 1e-30f, 1e30f));
    footprint.step[set] = (uv.b - uv.a) * step.x() + (uv.c - uv.a) * step.y();
  }
  if (sets == 1) {
    footprint.uv[1] = footprint.uv[0];
    footprint.log2_width[1] = footprint.log2_width[0];
    footprint.step[1] = footprint.step[0];
  }
  return footprint;
}

}  // namespace cps
