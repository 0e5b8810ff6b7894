#include "renderer/cache/cell_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "renderer/paths/hit_ids.h"
#include "renderer/paths/path_steps.h"

namespace cps {
namespace {

/// Points drawn in a cell, and in one whose light is uncertain by more than max_error after the first.
constexpr int first_points = 64, most_points = 256;
constexpr float max_error = 0.04f;
constexpr int min_points = 8;    ///< found among the first
constexpr int max_layers = 4;    ///< surfaces of other cells that a ray through a cell may pass
constexpr float near_cells = 2;  ///< a surface within so many cells is near
constexpr float max_near_share = 0.05f;

/// Random pairs that no path uses (random_pairs.h).
enum CellPair : std::uint32_t { pair_depth = 1u << 20 };

/// A point on a surface of a cell.
struct SurfacePoint {
  Vec3 position, normal;
  float clearance;
};

/// Where the line through a cell leaves it in `direction` from `inside`, metres.
float way_out(const Vec3& corner, float size, const Vec3& inside, const Vec3& direction) {
  float nearest = std::numeric_limits<float>::max();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 1e-6f) continue;
    const float wall = corner[axis] + (direction[axis] > 0.0f ? size : 0.0f);
    nearest = std::min(nearest, (wall - inside[axis]) / direction[axis]);
  }
  return std::max(nearest, 0.0f);
}

/// A point of the cube, spread best across the cell's facing.
Vec3 point_inside(const Cell& cell, const Vec3& facing, const SobolSample& random) {
  const Eigen::Vector2f across = random.joint_pair(0);
  Eigen::Index axis;
  facing.cwiseAbs().maxCoeff(&axis);
  Vec3 unit;
  unit[axis] = random.pair(pair_depth).x();
  unit[(axis + 1) % 3] = across.x();
  unit[(axis + 2) % 3] = across.y();
  return cell_corner(cell) + cell_size_m(cell.level) * unit;
}

/// The first of the cell's surfaces along a line through it, against its facing.
std::optional<SurfacePoint> find_point(const RenderScene& scene, const Cell& cell, const SobolSample& random,
                                       std::uint32_t& rays) {
  const Vec3 facing = facing_direction(cell.facing), corner = cell_corner(cell);
  const float size = cell_size_m(cell.level);
  const Vec3 inside = point_inside(cell, facing, random);
  Ray ray{.origin = inside + way_out(corner, size, inside, facing) * facing,
          .direction = -facing,
          .meets_car = false,
          .id = first_ray_id(random)};
  ray.t_far = way_out(corner, size, ray.origin, ray.direction);
  for (int layer = 0; layer < max_layers; ++layer) {
    ++rays;
    const Hit hit = scene.bvh.intersect(ray);
    if (!hit) return {};
    const WorldTriangle triangle = world_triangle(scene.placed, hit.placement, hit.triangle);
    const float length = triangle.normal.norm();
    if (length > 0.0f) {
      Vec3 normal = triangle.normal / length;
      if (normal.dot(ray.direction) > 0.0f) normal = -normal;
      if (ids_of(scene, hit).material == cell.material && facing_of(normal) == cell.facing)
        return SurfacePoint{
            interpolate(triangle.positions[0], triangle.positions[1], triangle.positions[2], hit.u, hit.v),
            normal, rounding_of(triangle)};
    }
    ray.t_near = hit.t + std::max(rounding_of(triangle), 1e-6f * hit.t);
  }
  return {};
}

/// A white Lambert surface, seen from straight above.
Surface white_surface(const SurfacePoint& point) {
  Surface surface;
  surface.position = point.position;
  surface.geometric_normal = point.normal;
  surface.shading = frame_around(point.normal);
  surface.wo = Vec3::UnitZ();
  surface.bsdf = make_bsdf({.base_color = Color::Ones(), .dielectric_f0 = Color::Zero(), .dielectric_f90 = 0},
                           surface.wo);
  surface.scatters = true;
  surface.base_color = Color::Ones();
  surface.emission = Color::Zero();
  surface.clearance = point.clearance;
  surface.meets_car = false;
  return surface;
}

/// Sums over the points of a cell.
struct CellSum {
  int points = 0, near = 0;
  Color radiance = Color::Zero();
  Vec3 towards = Vec3::Zero();
  float luminance = 0, squares = 0;

  /// Standard error of the mean luminance over the mean, as if points were independent.
  float relative_error() const {
    const auto n = static_cast<float>(points);
    const float variance = std::max(squares - luminance * luminance / n, 0.0f) / (n - 1);
    return luminance > 0.0f ? std::sqrt(n * variance) / luminance : 0.0f;
  }
};

/// Traces the paths of up to a packet of points and adds what they bring.
void trace_points(const RenderScene& scene, const Cell& cell, const ShadeVertex& shade,
                  const Surface (&surfaces)[packet_size], const SobolSample (&randoms)[packet_size],
                  const bool (&found)[packet_size], CellSum& sum, std::uint32_t& rays) {
  const float size = cell_size_m(cell.level);
  Path paths[packet_size];
  Vec3 directions[packet_size];
  float cosines[packet_size];
  ShadowRay sky_rays[packet_size];
  bool is_near[packet_size] = {}, is_buried[packet_size] = {};
  for (int i = 0; i < packet_size; ++i) {
    if (!found[i]) continue;
    Path& path = paths[i];
    path.random = randoms[i];
    path.alive = true;
    sky_rays[i] = towards_sky(scene, path, surfaces[i]);
    const Vec3 local = sample_cosine_hemisphere(path.random.joint_pair(1));
    cosines[i] = local.z();
    directions[i] = surfaces[i].shading.to_world(local);
    send_from_diffuse(path, surfaces[i], directions[i], local.z() * std::numbers::inv_pi_v<float>);
    path.ray.id = first_ray_id(path.random);
    path.skips_sun_and_lamps = true;
    path.met_surfaces = 1;
  }
  gather_all(scene, sky_rays, false, &VertexRecord::sky, paths);
  Color by_sample[packet_size];
  for (int i = 0; i < packet_size; ++i) by_sample[i] = paths[i].radiance;

  trace_paths_with(scene, false, paths, [&](Path& path, const Hit& hit) -> SunAndSkyRays {
    const auto i = &path - paths;
    if (path.shaded_vertices == 1 && path.met_surfaces == 1) {
      is_near[i] = hit.t < near_cells * size;
      is_buried[i] = hit.t < size && is_culled(scene.placed, path.ray, hit);
    }
    return shade(path, hit);
  });

  for (int i = 0; i < packet_size; ++i) {
    rays += paths[i].rays;
    if (!found[i] || is_buried[i]) continue;
    ++sum.points;
    sum.near += is_near[i];
    sum.radiance += paths[i].radiance;
    const float brightness = luminance(paths[i].radiance);
    sum.luminance += brightness;
    sum.squares += brightness * brightness;
    // Light samples of the sky count for the mean direction, too, each in its own.
    const float drawn = luminance(paths[i].radiance - by_sample[i]) / std::max(cosines[i], 0.1f);
    sum.towards += drawn * directions[i];
    if (sky_rays[i].wanted) {
      const Vec3& direction = sky_rays[i].ray.direction;
      sum.towards +=
          luminance(by_sample[i]) / std::max(surfaces[i].geometric_normal.dot(direction), 0.1f) * direction;
    }
  }
}

}  // namespace

CellLight compute_cell_light(const RenderScene& scene, const Cell& cell, const ShadeVertex& shade,
                             std::uint32_t& rays) {
  const std::uint64_t key = cell.hash();
  CellSum sum;
  for (int first = 0; first < most_points; first += packet_size) {
    if (first == first_points && (sum.points < min_points || sum.relative_error() < max_error)) break;
    SobolSample randoms[packet_size];
    Surface surfaces[packet_size];
    bool found[packet_size];
    for (int i = 0; i < packet_size; ++i) {
      randoms[i] = {key, static_cast<std::uint32_t>(first + i)};
      const auto point = find_point(scene, cell, randoms[i], rays);
      found[i] = point.has_value();
      if (point) surfaces[i] = white_surface(*point);
    }
    if (std::ranges::any_of(found, [](bool is) { return is; }))
      trace_points(scene, cell, shade, surfaces, randoms, found, sum, rays);
  }
  CellLight light;
  light.is_known = sum.points >= min_points;
  if (!light.is_known) return light;
  const auto count = static_cast<float>(sum.points);
  light.radiance = sum.radiance / count;
  light.is_near = static_cast<float>(sum.near) > max_near_share * count;
  light.towards = sum.towards.normalized();
  return light;
}

}  // namespace cps
