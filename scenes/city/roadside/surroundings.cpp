#include "scenes/city/roadside/surroundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/noise.h"
#include "scenes/city/roadside/tree.h"

namespace cps::city {
namespace {

using std::numbers::pi;

constexpr double horizon_m = 6000;
constexpr int directions = 192;

/// Height of the country: just below the pavements at the rim of the built area, hills far away.
struct Ground {
  Polygon rim;
  Stream stream;
  double hills_m;

  double beyond(const Vec2& p) const { return distance_to_polygon(rim, p); }
  double height(const Vec2& p) const {
    const double d = beyond(p);
    if (d <= 0) return -0.5;
    const double far = std::clamp((d - 80) / 2500, 0.0, 1.0);
    const double u = p.x() / 16384 + 0.5, v = p.y() / 16384 + 0.5;
    const double roll = 0.5 + fractal_noise(stream, u, v, 12, 4),
                 bumps = fractal_noise(substream(stream, 9), u, v, 160, 3);
    return 0.05 + hills_m * far * far * (3 - 2 * far) * std::clamp(roll, 0.05, 1.2) +
           4 * bumps * std::min(1.0, d / 400);
  }
};

Mesh make_terrain(const Ground& ground, MaterialId material, Stream stream) {
  Mesh mesh{"terrain", {}};
  Surface& s = mesh.surfaces[material];
  std::vector<double> radii{0};
  for (double r = 15; r < 120; r += 15) radii.push_back(r);  // fine enough for the city's slopes
  for (double r = 120; r < horizon_m; r *= 1.055) radii.push_back(r);
  for (double radius : radii)
    for (int i = 0; i < directions; ++i) {
      const double a = 2 * pi * i / directions;
      const Vec2 p(radius * std::cos(a), radius * std::sin(a));
      const auto slope = [&](const Vec2& step) {
        return (ground.height(p + step) - ground.height(p - step)) / 20;
      };
      const Vec3 normal =
          ground.beyond(p) > 12 ? Vec3(-slope({10, 0}), 1, slope({0, 10})).normalized() : Vec3(0, 1, 0);
      s.positions.push_back(lift(p, ground.height(p)).cast<float>());
      s.normals.push_back(normal.cast<float>());
      s.uvs.emplace_back(0.f, 0.f);
      // Fields and woods; with distance they fade towards the sky's colour (aerial perspective).
      const double wood =
          std::clamp(0.5 + 2.5 * fractal_noise(stream, p.x() / 8192, p.y() / 8192, 40, 4), 0.0, 1.0);
      const double air = std::clamp(radius / 9000, 0.0, 0.5);
      const std::array<double, 3> near{std::lerp(0.42, 0.13, wood), std::lerp(0.44, 0.20, wood),
                                       std::lerp(0.22, 0.09, wood)};
      const std::array<double, 3> sky{0.55, 0.65, 0.78};
      std::array<std::uint8_t, 4> color{0, 0, 0, 255};
      for (int c = 0; c < 3; ++c)
        color[c] = static_cast<std::uint8_t>(255 * std::lerp(near[c] * 0.6, sky[c] * 0.6, air));
      s.colors.push_back(color);
    }
  for (std::uint32_t r = 0; r + 1 < radii.size(); ++r)
    for (std::uint32_t i = 0; i < directions; ++i) {
      const std::uint32_t a = r * directions + i, b = r * directions + (i + 1) % directions;
      if (r > 0) s.indices.insert(s.indices.end(), {a, b + directions, b});
      s.indices.insert(s.indices.end(), {a, a + directions, b + directions});
    }
  return mesh;
}

}  // namespace

Surroundings surroundings(const StreetNetwork& network, const Materials& materials,
                          const ModelLibrary& models, const CityOptions& options) {
  Draws draws{make_stream(options.seed, "surroundings")};
  const Ground ground{network.rim, substream(draws.stream, 1),
                      draws.chance(0.25) ? draws.uniform(10, 40) : draws.uniform(60, 260)};
  Surroundings result;
  result.terrain = make_terrain(ground, materials.terrain, substream(draws.stream, 2));
  const auto place = [&](const Model& model, double distance, double bearing, double heading, double scale) {
    const Vec2 direction(std::cos(bearing), std::sin(bearing));
    double r = options.extent_m / 2;
    while (ground.beyond(direction * r) < distance) r += 2;
    const Vec2 p = direction * r;
    result.models.push_back({&model, p, ground.height(p) - 0.4, heading, scale});
    const Polygon site = result.models.back().footprint();
    for (std::size_t i = 0; i + 1 < result.models.size(); ++i)
      if ((result.models[i].position - p).norm() < 40 && overlap(site, result.models[i].footprint(), 0))
        return result.models.pop_back();
  };
  const int houses = static_cast<int>(options.extent_m * draws.uniform(0.25, 0.5));
  for (int i = 0; i < houses; ++i) {
    const double distance = 22 + 500 * std::pow(draws.uniform(0, 1), 1.7);
    const std::size_t kind = draws.chance(0.75) ? draws.integer(0, 3) : draws.integer(4, 6);
    place(models.far_houses[kind], distance + (kind > 3 ? 40 : 0), draws.uniform(0, 2 * pi),
          draws.uniform(0, 2 * pi), 1);
  }
  const int trees = static_cast<int>(options.extent_m * draws.uniform(0.5, 1.3) * options.tree_density);
  for (int i = 0; i < trees; ++i) {
    const double distance = 14 + 700 * std::pow(draws.uniform(0, 1), 2.2);
    const std::vector<Model>& species =
        models.trees[draws.one_of<int>({lime, lime, maple, plane, plane, spruce, poplar, birch, pine})];
    const Model& model = draws.one_of(species);
    place(model, distance, draws.uniform(0, 2 * pi), draws.uniform(0, 2 * pi), draws.uniform(0.9, 1.6));
  }
  return result;
}

}  // namespace cps::city
