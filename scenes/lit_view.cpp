#include "scenes/lit_view.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "numbers/luminance.h"
#include "scenes/lattice.h"
#include "scenes/surface_color.h"

namespace cps {
namespace {

constexpr float sky_kcd_m2 = 5;      ///< order of magnitude of skies by day, clear or overcast
constexpr float lit_kcd_m2 = 1e-4f;  ///< a street by night has a hundred times as much

float luminance_of(const Eigen::Vector3f& color) {
  return luminance(color.x(), color.y(), color.z());
}

template <std::size_t count>
std::array<Eigen::Vector3f, count> sphere() {
  std::array<Eigen::Vector3f, count> directions;
  for (std::size_t i = 0; i < count; ++i)
    directions[i] = lattice_direction(static_cast<int>(i), count, -1).template cast<float>();
  return directions;
}

/// Illuminance (klx) at a point from lamps that it sees.
float from_lamps(const SceneRays& rays, const SceneLight& light, const Eigen::Vector3f& point,
                 const Eigen::Vector3f& normal) {
  float illuminance = 0;
  for (const PunctualLight& lamp : light.lights) {
    const bool is_distant = lamp.kind == PunctualLight::Kind::directional;
    const Eigen::Vector3f offset = is_distant ? Eigen::Vector3f(-lamp.direction) : lamp.position - point;
    const float distance_m = offset.norm();
    const Eigen::Vector3f direction = offset / distance_m;
    const float cosine = normal.dot(direction);
    if (!(cosine > 0)) continue;
    if (lamp.kind == PunctualLight::Kind::spot && -direction.dot(lamp.direction) < lamp.cos_outer) continue;
    const auto hit = first_hit(rays, point, direction);
    if (hit && (is_distant || hit->distance_m < distance_m)) continue;
    illuminance += luminance_of(lamp.intensity) * cosine / (is_distant ? 1 : distance_m * distance_m);
  }
  return illuminance;
}

/// Mean luminance of what shines on a point from the half space above it, weighted by the cosine.
float from_around(const SceneRays& rays, const SceneLight& light, const Eigen::Vector3f& point,
                  const Eigen::Vector3f& normal) {
  static const auto directions = sphere<32>();
  float sum = 0, weights = 0;
  for (const Eigen::Vector3f& direction : directions) {
    const float cosine = normal.dot(direction);
    if (cosine < 0.1f) continue;
    const auto hit = first_hit(rays, point, direction);
    sum += cosine * (hit ? light.emitted_kcd_m2[hit->instance] : sky_kcd_m2);
    weights += cosine;
  }
  return weights > 0 ? sum / weights : 0;
}

float luminance_along(const SceneRays& rays, const SceneLight& light, const Eigen::Vector3f& from,
                      const Eigen::Vector3f& direction) {
  const auto hit = first_hit(rays, from, direction);
  if (!hit) return sky_kcd_m2;
  const Eigen::Vector3f normal = hit->normal.dot(direction) < 0 ? hit->normal : Eigen::Vector3f(-hit->normal);
  const auto distance_m = static_cast<float>(hit->distance_m);
  const Eigen::Vector3f point = from + distance_m * direction + (0.001f + 1e-4f * distance_m) * normal;
  const float received = from_around(rays, light, point, normal) +
                         from_lamps(rays, light, point, normal) / std::numbers::pi_v<float>;
  return light.emitted_kcd_m2[hit->instance] + light.albedo[hit->instance] * received;
}

}  // namespace

SceneLight scene_light(const Scene& scene) {
  std::vector<float> albedo, emitted;
  for (const Material& material : scene.materials) {
    albedo.push_back(luminance_of(mean_base_color(scene, material)));
    emitted.push_back(luminance_of(mean_emission(scene, material)));
  }
  SceneLight light{.lights = scene.lights, .albedo = {}, .emitted_kcd_m2 = {}};
  for (const Instance& instance : scene.instances) {
    const int material = scene.meshes[instance.mesh].material;
    light.albedo.push_back(albedo[material]);
    light.emitted_kcd_m2.push_back(emitted[material]);
  }
  return light;
}

PlaceFault light_fault(const SceneRays& rays, const SceneLight& light, const Eigen::Vector3d& position,
                       const Eigen::Vector3d& forward) {
  constexpr float cos_ahead = 0.7071f;  // 45°
  constexpr double min_lit_share = 0.1, max_white_share = 1.0 / 3;
  constexpr float grey = 0.18f, max_over_median = 8;  // as meter_exposure()
  static const auto directions = sphere<256>();
  const Eigen::Vector3f axis = forward.normalized().cast<float>();
  std::vector<float> seen;
  for (const Eigen::Vector3f& direction : directions)
    if (direction.dot(axis) > cos_ahead)
      seen.push_back(luminance_along(rays, light, position.cast<float>(), direction));
  std::ranges::sort(seen);
  const auto count = static_cast<double>(seen.size());
  const auto share_above = [&](float level) {
    return static_cast<double>(std::ranges::count_if(seen, [&](float one) { return one > level; })) / count;
  };
  if (share_above(lit_kcd_m2) < min_lit_share) return PlaceFault::dark;
  const float cap = max_over_median * seen[seen.size() / 2];
  float metered = 0;
  for (const float one : seen) metered += std::min(one, cap) / static_cast<float>(count);
  return share_above(std::max(metered / grey, lit_kcd_m2)) > max_white_share ? PlaceFault::blown_out
                                                                             : PlaceFault::none;
}

}  // namespace cps
