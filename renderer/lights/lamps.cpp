#include "renderer/lights/lamps.h"

#include <algorithm>
#include <cmath>

#include "renderer/math/fast_math.h"

namespace cps {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

bool shines(const Geometry& geometry) {
  return geometry.material->emits && !geometry.material->unlit && !geometry.viewer_only;
}

/// Mean emission of a triangle, by one texture lookup as wide as the triangle.
float mean_luminance(const Geometry& geometry, std::uint32_t triangle) {
  const SurfaceMaterial& material = *geometry.material;
  TextureFootprint at = geometry.full_detail(triangle, 1.0f / 3, 1.0f / 3);
  const int set = material.emissive_texture.uv_set;
  const float area = geometry.corner_uv(triangle, set).double_area();
  at.log2_width[set] = 0.5f * log2_of(std::clamp(area, 1e-30f, 1e30f));
  return luminance(material.emissive * material.emissive_texture.sample(at).head<3>());
}

LampBounds bounds_of(const PlacedGeometry& placed, std::uint32_t placement, std::uint32_t triangle) {
  const WorldTriangle t = world_triangle(placed, placement, triangle);
  LampBounds bounds;
  for (const Vec3& position : t.positions) bounds.box.extend(position);
  const float double_area = t.normal.norm();
  if (!(double_area > 0.0f)) return bounds;
  bounds.axis = t.normal / double_area;
  bounds.intensity = 0.5f * double_area * mean_luminance(t.geometry, triangle);
  bounds.two_sided = t.geometry.material->double_sided;
  return bounds;
}

LampBounds bounds_of(const PunctualLight& light) {
  LampBounds bounds;
  bounds.box.extend(light.position);
  bounds.intensity = luminance(light.intensity.array());
  bounds.axis = light.direction;
  if (light.kind == PunctualLight::Kind::spot) {
    bounds.cos_cone = light.cos_inner;
    const float sines = std::sqrt(std::max(0.0f, 1 - light.cos_inner * light.cos_inner) *
                                  (1 - light.cos_outer * light.cos_outer));
    bounds.cos_falloff = std::min(1.0f, light.cos_inner * light.cos_outer + sines);
  } else {
    bounds.cos_cone = -1;
  }
  return bounds;
}

/// Angular attenuation as KHR_lights_punctual computes it.
float spot_falloff(const PunctualLight& light, float cosine) {
  if (light.kind != PunctualLight::Kind::spot) return 1.0f;
  const float width = std::max(light.cos_inner - light.cos_outer, 1e-3f);
  const float root = std::clamp((cosine - light.cos_outer) / width, 0.0f, 1.0f);
  return root * root;
}

LampSample sample_point(const PunctualLight& light, const Vec3& point, float probability) {
  LampSample sample;
  const Vec3 to_light = light.position - point;
  sample.distance = to_light.norm();
  if (!(sample.distance > 0.0f)) return sample;
  sample.direction = to_light / sample.distance;
  const float share = spot_falloff(light, -light.direction.dot(sample.direction));
  sample.light_over_pdf =
      light.intensity.array() * (share / (sample.distance * sample.distance * probability));
  sample.pdf = share > 0.0f ? infinite : 0.0f;
  return sample;
}

/// Density per solid angle, seen from `point`, of a point `at` drawn uniformly on a triangle.
float area_pdf(const WorldTriangle& t, const Vec3& point, const Vec3& at) {
  const Vec3 to_point = point - at;
  const float distance2 = to_point.squaredNorm();
  const float projected = 0.5f * std::abs(t.normal.dot(to_point));  // area · cos · distance
  return projected > 0.0f ? distance2 * std::sqrt(distance2) / projected : infinite;
}

LampSample sample_triangle(const PlacedGeometry& placed, const Lamps::Emitter& emitter, const Vec3& point,
                           float probability, const Eigen::Vector2f& u) {
  LampSample sample;
  const WorldTriangle t =
      world_triangle(placed, static_cast<std::uint32_t>(emitter.placement), emitter.index);
  const float root = std::sqrt(u.x());
  const float b = root * (1.0f - u.y()), c = root * u.y();
  const Vec3 at = interpolate(t.positions[0], t.positions[1], t.positions[2], b, c);
  const Vec3 to_lamp = at - point;
  const float distance = to_lamp.norm();
  const SurfaceMaterial& material = *t.geometry.material;
  if (!(distance > 0.0f) || (t.normal.dot(to_lamp) >= 0.0f && !material.double_sided)) return sample;
  const float pdf = probability * area_pdf(t, point, at);
  if (!std::isfinite(pdf)) return sample;
  const TextureFootprint lookup = t.geometry.full_detail(emitter.index, b, c);
  const Color radiance = material.emissive * material.emissive_texture.sample(lookup).head<3>() *
                         t.geometry.coverage(emitter.index, b, c);
  sample.direction = to_lamp / distance;
  sample.distance = distance - 1e-5f * distance - rounding_of(t);
  sample.light_over_pdf = radiance / pdf;
  sample.pdf = pdf;
  return sample;
}

}  // namespace

LampSample Lamps::sample(const PlacedGeometry& placed, const Vec3& point, const Vec3& normal, float u_choice,
                         const Eigen::Vector2f& u) const {
  const LampTree::Choice choice = tree.choose(point, normal, u_choice);
  if (!(choice.probability > 0.0f)) return {};
  const Emitter& emitter = emitters[choice.lamp];
  if (emitter.placement < 0) return sample_point(points[emitter.index], point, choice.probability);
  return sample_triangle(placed, emitter, point, choice.probability, u);
}

LampSample Lamps::sample_direction(float u) const {
  const auto above = std::upper_bound(direction_cdf.begin() + 1, direction_cdf.end() - 1, u);
  const auto index = static_cast<std::size_t>(above - direction_cdf.begin()) - 1;
  LampSample sample;
  sample.direction = -directions[index].direction;
  sample.distance = infinite;
  sample.light_over_pdf =
      directions[index].intensity.array() / (direction_cdf[index + 1] - direction_cdf[index]);
  sample.pdf = infinite;
  return sample;
}

float Lamps::pdf(const PlacedGeometry& placed, const Vec3& point, const Vec3& normal, std::uint32_t placement,
                 std::uint32_t triangle, const Vec3& at) const {
  if (first_emitter[placement] < 0) return 0.0f;
  const std::uint32_t lamp = static_cast<std::uint32_t>(first_emitter[placement]) + triangle;
  const float chosen = tree.probability(point, normal, lamp);
  return chosen > 0.0f ? chosen * area_pdf(world_triangle(placed, placement, triangle), point, at) : 0.0f;
}

Lamps make_lamps(const Scene& scene, const PlacedGeometry& placed) {
  Lamps lamps;
  std::vector<LampBounds> bounds;
  for (std::size_t i = 0; i < placed.placements.size(); ++i) {
    const Geometry& geometry = placed.geometries[placed.placements[i].geometry];
    const bool shining = shines(geometry);
    lamps.first_emitter.push_back(shining ? static_cast<std::int32_t>(lamps.emitters.size()) : -1);
    if (!shining) continue;
    for (std::uint32_t triangle = 0; triangle < geometry.triangles.size(); ++triangle) {
      lamps.emitters.push_back({static_cast<std::int32_t>(i), triangle});
      bounds.push_back(bounds_of(placed, static_cast<std::uint32_t>(i), triangle));
    }
  }
  float sum = 0.0f;
  lamps.direction_cdf.push_back(0.0f);
  for (const PunctualLight& light : scene.lights) {
    const float strength = luminance(light.intensity.array());
    if (!(strength > 0.0f)) continue;
    if (light.kind == PunctualLight::Kind::directional) {
      lamps.directions.push_back(light);
      lamps.direction_cdf.push_back(sum += strength);
    } else {
      lamps.emitters.push_back({-1, static_cast<std::uint32_t>(lamps.points.size())});
      lamps.points.push_back(light);
      bounds.push_back(bounds_of(light));
    }
  }
  for (float& step : lamps.direction_cdf) step /= std::max(sum, 1e-30f);
  lamps.tree = make_lamp_tree(bounds);
  return lamps;
}

}  // namespace cps
