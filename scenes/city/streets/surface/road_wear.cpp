#include "scenes/city/streets/surface/road_wear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

void add_manhole(Mesh& mesh, const Vec2& centre, const Materials& m) {
  constexpr double radius = 0.33, height = seam_height_m + 0.0005;
  std::vector<Vertex> rim(24);
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * std::numbers::pi * i / 24;
    rim[i] = {lift(centre + Vec2(std::cos(a), std::sin(a)) * radius, height)};
  }
  add_polygon(mesh.surfaces[m.manhole], rim);
}

/// A tarred crack: a seam that meanders along the road.
void add_seam(Surface& surface, const Polyline& centre, double from, double to, double left_m, double limit,
              Draws& draws) {
  Polyline seam;
  double wander = left_m;
  for (double s = from; s <= to; s += 0.6) {
    wander = std::clamp(wander + draws.uniform(-0.12, 0.12), -limit, limit);
    const Station at = station_at(centre, s);
    seam.push_back(at.point + left_of(at.direction) * wander);
  }
  if (seam.size() > 2) add_stripe(surface, seam, draws.uniform(0.03, 0.06), seam_height_m, 1);
}

}  // namespace

void add_wear(Mesh& mesh, const Polyline& centre, const StreetProfile& profile, const Materials& m,
              double wear, Draws& draws) {
  const double total = length(centre), half = profile.half_width();
  const int patches = static_cast<int>(total / 30 * wear * draws.uniform(0.3, 1.8));
  for (int i = 0; i < patches; ++i) {
    const double l = draws.uniform(1.0, 7), w = draws.uniform(0.7, 2.4);
    const double s = draws.uniform(1, std::max(1.1, total - l - 1));
    const double left = draws.uniform(-half + w / 2 + 0.5, half - w / 2 - 0.5);
    if (s + l < total - 0.5)
      add_stripe(mesh.surfaces[m.asphalt_patch], offset(cut(centre, s, s + l), left), w,
                 patch_height_m * (1 + 0.1 * i), asphalt_tile_m);
  }
  const int seams = static_cast<int>(total / 22 * wear * draws.uniform(0.3, 2.2));
  for (int i = 0; i < seams; ++i) {
    const double from = draws.uniform(0.5, total * 0.8);
    add_seam(mesh.surfaces[m.tar], centre, from, std::min(total - 0.5, from + draws.uniform(3, 18)),
             draws.uniform(-half + 0.6, half - 0.6), half - 0.5, draws);
  }
  for (double s = draws.uniform(6, 30); s < total - 2; s += draws.uniform(22, 45)) {
    const Station at = station_at(centre, s);
    add_manhole(mesh, at.point + left_of(at.direction) * draws.uniform(-half + 1, half - 1), m);
  }
}

void add_junction_wear(Mesh& mesh, const Polygon& border, const Vec2& middle, double clear_radius_m,
                       const Materials& m, double wear, Draws& draws) {
  // A random point between the middle and the border, but not under an island.
  const auto somewhere = [&] {
    const Vec2 out = border[draws.integer(0, static_cast<int>(border.size()) - 1)] - middle;
    const double from = std::min(0.9, (clear_radius_m + 1) / out.norm());
    return Vec2(middle + out * draws.uniform(from, std::max(from, 0.85)));
  };
  const auto is_on_road = [&](const Vec2& p) {
    return contains(border, p) && (p - middle).norm() > clear_radius_m + 0.5;
  };
  for (int i = draws.integer(1, 3); i > 0; --i) {
    const Vec2 at = somewhere();
    if (is_on_road(at)) add_manhole(mesh, at, m);
  }
  for (int i = static_cast<int>(2.5 * wear * draws.uniform(0.3, 1.6)); i > 0; --i) {
    Polyline seam{somewhere()};
    double heading = draws.uniform(0, 2 * std::numbers::pi);
    for (int k = draws.integer(6, 22); k > 0 && is_on_road(seam.back()); --k) {
      heading += draws.uniform(-0.25, 0.25);
      seam.push_back(seam.back() + Vec2(std::cos(heading), std::sin(heading)) * 0.6);
    }
    seam.pop_back();
    if (seam.size() > 2) add_stripe(mesh.surfaces[m.tar], seam, draws.uniform(0.03, 0.06), seam_height_m, 1);
  }
  for (int i = static_cast<int>(1.3 * wear * draws.uniform(0, 1.5)); i > 0; --i) {
    const Vec2 at = somewhere(), along = (middle - at).normalized();
    const double half_length = draws.uniform(0.6, 2.6), width = draws.uniform(0.7, 2);
    const Polyline line{at - along * half_length, at + along * half_length};
    if (is_on_road(line[0]) && is_on_road(line[1]))
      add_stripe(mesh.surfaces[m.asphalt_patch], line, width, patch_height_m, asphalt_tile_m);
  }
}

}  // namespace cps::city
