#include "scenes/places/lit_view.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "numbers/luminance.h"
#include "numbers/metering.h"
#include "scenes/lattice.h"
#include "scenes/surface_color.h"

namespace cps {
namespace {

constexpr float sky_kcd_m2 = 5;      ///< order of magnitude of skies by day, clear or overcast
constexpr float lit_kcd_m2 = 1e-4f;  ///< a street by night has a hundred times as much

float luminance_of(const Eigen::Vector3f& color) {
  return luminance(color.x(), color.y(), color.z());
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
  float sum = 0, weights = 0;
  for (const Eigen::Vector3f& direction : sphere_directions<32>()) {
    const float cosine = normal.dot(direction);
    if (cosine < 0.1f) continue;
    const auto hit = first_hit(rays, point, direction);
    sum += cosine * (hit ? light.emitted_kcd_m2[hit->instance] : sky_kcd_m2);
    weights += cosine;
  }
  return weights > 0 ? sum / weights : 0;
}

/// Luminance of a surface that is seen along a direction.
float surface_luminance(const SceneRays& rays, const SceneLight& light, const Eigen::Vector3f& from,
                        const Eigen::Vector3f& direction, const SurfaceHit& hit) {
  const Eigen::Vector3f normal = hit.normal.dot(direction) < 0 ? hit.normal : Eigen::Vector3f(-hit.normal);
  const auto distance_m = static_cast<float>(hit.distance_m);
  const Eigen::Vector3f point = from + distance_m * direction + (0.001f + 1e-4f * distance_m) * normal;
  const float received = from_around(rays, light, point, normal) +
                         from_lamps(rays, light, point, normal) / std::numbers::pi_v<float>;
  return light.emitted_kcd_m2[hit.instance] + light.albedo[hit.instance] * received;
}

/// What is known of the luminances along a few directions while surfaces are looked at one by one.
struct Bounds {
  std::vector<float> low, high;
};

double share_above(const std::vector<float>& luminances, double level) {
  return static_cast<double>(std::ranges::count_if(luminances, [&](float one) { return one > level; })) /
         static_cast<double>(luminances.size());
}

/// Whether so much may be lit that a picture is not dark. Exact where the bounds meet.
bool is_lit(const std::vector<float>& luminances) {
  constexpr double min_lit_share = 0.1;
  return share_above(luminances, lit_kcd_m2) >= min_lit_share;
}

/// Whether more than a third may be white. Exposure falls as luminances grow, so that the low ones give the
/// most. Where metering finds only black, all that is lit stands out.
bool may_blow_out(const Bounds& bounds) {
  constexpr double max_white_share = 1.0 / 3, max_exposure = 1 / lit_kcd_m2;
  std::vector<float> low = bounds.low;
  const double exposure = std::min(metered_exposure(low).value_or(max_exposure), max_exposure);
  return share_above(bounds.high, 1 / exposure) > max_white_share;
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
    light.max_received_kcd_m2 = std::max(light.max_received_kcd_m2, emitted[material]);
  }
  light.max_received_kcd_m2 = light.lights.empty() ? std::max(light.max_received_kcd_m2, sky_kcd_m2)
                                                   : std::numeric_limits<float>::max();
  return light;
}

PlaceFault light_fault(const SceneRays& rays, const SceneLight& light, const Eigen::Vector3d& position,
                       const Eigen::Vector3d& forward) {
  constexpr float cos_ahead = 0.7071f;  // 45°
  const Eigen::Vector3f axis = forward.normalized().cast<float>(), from = position.cast<float>();
  struct Seen {
    Eigen::Vector3f direction;
    SurfaceHit hit;
    std::size_t index;  ///< into the bounds
  };
  std::vector<Seen> surfaces;
  Bounds bounds;
  for (const Eigen::Vector3f& direction : sphere_directions<256>()) {
    if (!(direction.dot(axis) > cos_ahead)) continue;
    const auto hit = first_hit(rays, from, direction);
    if (hit) surfaces.push_back({direction, *hit, bounds.low.size()});
    bounds.low.push_back(hit ? light.emitted_kcd_m2[hit->instance] : sky_kcd_m2);
    bounds.high.push_back(hit ? light.emitted_kcd_m2[hit->instance] +
                                    light.albedo[hit->instance] * light.max_received_kcd_m2
                              : sky_kcd_m2);
  }
  // Most places are good after a few surfaces.
  for (const Seen& seen : surfaces) {
    if (is_lit(bounds.low) && !may_blow_out(bounds)) return PlaceFault::none;
    bounds.low[seen.index] = bounds.high[seen.index] =
        surface_luminance(rays, light, from, seen.direction, seen.hit);
  }
  if (!is_lit(bounds.low)) return PlaceFault::dark;
  return may_blow_out(bounds) ? PlaceFault::blown_out : PlaceFault::none;
}

}  // namespace cps
