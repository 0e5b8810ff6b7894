#include "scenes/city/streets/terrain.h"

#include <cmath>
#include <numbers>

#include "scenes/city/draws.h"
#include "scenes/city/geometry/refine.h"

namespace cps::city {

double Terrain::height_m(const Vec2& plan) const {
  double height = 0;
  for (const Wave& w : waves) height += w.amplitude_m * std::sin(w.per_metre.dot(plan) + w.phase_rad);
  return height;
}

Vec2 Terrain::slope(const Vec2& plan) const {
  Vec2 rise(0, 0);
  for (const Wave& w : waves)
    rise += w.per_metre * (w.amplitude_m * std::cos(w.per_metre.dot(plan) + w.phase_rad));
  return rise;
}

double Terrain::steepest() const {
  double sum = 0;
  for (const Wave& w : waves) sum += w.amplitude_m * w.per_metre.norm();
  return sum;
}

double slope_limit(CityStyle style) {
  switch (style) {
    case CityStyle::european:
    case CityStyle::suburb:
      return 0.06;
    case CityStyle::mixed:
      return 0.04;
    case CityStyle::downtown:
      return 0.035;
    case CityStyle::industrial:
      return 0.02;
  }
  return 0;
}

Terrain draw_terrain(const CityOptions& options) {
  constexpr int count = 3;
  Draws draws{make_stream(options.seed, "terrain")};
  Terrain terrain;
  if (draws.chance(0.25)) return terrain;
  const double limit = slope_limit(options.style), steepest = draws.uniform(0.3 * limit, limit);
  double bearing = draws.uniform(0, 2 * std::numbers::pi);
  for (int i = 0; i < count; ++i) {
    const double wavelength_m = draws.uniform(350, 900);
    const double wave_number = 2 * std::numbers::pi / wavelength_m;
    // The first wave has most of the slope, because a sum of equal waves rarely comes near its bound.
    const double share = i == 0 ? 0.7 : 0.15;
    terrain.waves.push_back({Vec2(std::cos(bearing), std::sin(bearing)) * wave_number,
                             share * steepest / wave_number, draws.uniform(0, 2 * std::numbers::pi)});
    bearing += draws.uniform(0.5, 1.2);
  }
  return terrain;
}

void lift_onto(Mesh& mesh, const Terrain& terrain) {
  if (terrain.waves.empty()) return;
  for (auto& [material, surface] : mesh.surfaces)
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
      Eigen::Vector3f &p = surface.positions[i], &n = surface.normals[i];
      const Vec2 plan(p.x(), -p.z());
      const Vec2 slope = terrain.slope(plan);
      p.y() += static_cast<float>(terrain.height_m(plan));
      // The map is a vertical shear, so normals transform by its inverse transpose.
      n = Vec3(n.x() - slope.x() * n.y(), n.y(), n.z() + slope.y() * n.y()).normalized().cast<float>();
    }
}

void drape(Mesh& mesh, const Terrain& terrain, double longest_edge_m) {
  if (terrain.waves.empty()) return;
  for (auto& [material, surface] : mesh.surfaces) refine(surface, longest_edge_m);
  lift_onto(mesh, terrain);
}

std::vector<Vec3> on_terrain(const Polyline& line, const Terrain& terrain) {
  std::vector<Vec3> points;
  for (const Vec2& p : terrain.waves.empty() ? line : subdivided(line, max_road_edge_m))
    points.push_back(lift(p, terrain.height_m(p)));
  return points;
}

}  // namespace cps::city
