#include "scenes/city/roadside/tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/materials/textures.h"

namespace cps::city {
namespace {

using std::numbers::pi;

/// What the normals of a leaf card follow: the surface of a clump of leaves around `clump`, on a crown whose
/// surface faces `outwards`.
struct Leafage {
  Vec3 clump, outwards;
};

/// Adds a square card that stands on `foot`, the image's upper edge towards `up`, folded a little along a
/// diagonal. The normals of its corners follow the clump, so that shading varies across the card.
void add_card(Surface& surface, const Vec3& foot, const Vec3& up, const Vec3& facing, double size,
              const Leafage& leafage) {
  constexpr double fold = 0.16, roundness = 0.85;
  const Vec3 side = up.cross(facing).normalized() * (size / 2);
  Vec3 normal = side.cross(up).normalized();
  if (normal.dot(leafage.outwards) < 0) normal = -normal;
  const bool turned = normal.dot(side.cross(up)) < 0;
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  const Vec3 back = normal * (fold * size);
  const std::array<Vec3, 4> corners{foot - side, foot + side - back, foot + side + up * size,
                                    foot - side + up * size - back};
  constexpr float u[4] = {0, 1, 1, 0}, v[4] = {1, 1, 0, 0};
  for (int i = 0; i < 4; ++i) {
    const Vec3 from_clump = corners[i] - leafage.clump;
    Vec3 bent =
        leafage.outwards + 0.3 * normal + from_clump * (roundness / std::max(size, from_clump.norm()));
    // Keeps the normal in front of both halves, which the fold turns by 13°.
    const double across = bent.dot(normal), along = (bent - normal * across).norm();
    bent += normal * std::max(0.0, 0.4 * along - across);
    surface.positions.push_back(corners[i].cast<float>());
    surface.normals.push_back(bent.normalized().cast<float>());
    surface.uvs.emplace_back(u[i], v[i]);
  }
  if (turned)
    surface.indices.insert(surface.indices.end(), {first, first + 2, first + 1, first, first + 3, first + 2});
  else
    surface.indices.insert(surface.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

Vec3 random_direction(Draws& draws) {
  const double z = draws.uniform(-1, 1), a = draws.uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
  return {r * std::cos(a), z, r * std::sin(a)};
}

/// The crown's radius at relative height `t`, 0 at its lower end and 1 at its top.
double crown_profile(const TreeSpecies& s, double t) {
  if (s.whorled) return s.crown_radius_m * std::pow(1 - t, 0.85);
  const double x = t < s.crown_top ? (s.crown_top - t) / s.crown_top : (t - s.crown_top) / (1 - s.crown_top);
  return s.crown_radius_m * std::sqrt(std::max(0.0, 1 - std::pow(x, t < s.crown_top ? 2.0 : 2.4)));
}

void add_bent_tube(Surface& surface, const Vec3& from, const Vec3& to, double r0, double r1, int sides,
                   Draws& draws, Vec3* middle_out) {
  const double l = (to - from).norm();
  const Vec3 middle = (from + to) / 2 + random_direction(draws) * (0.06 * l);
  add_tube(surface, from, middle, r0, (r0 + r1) / 2, sides, false, bark_tile_m);
  add_tube(surface, middle, to, (r0 + r1) / 2, r1, sides, false, bark_tile_m);
  *middle_out = middle;
}

void add_broad_crown(Mesh& mesh, const TreeSpecies& s, MaterialId leaves, MaterialId bark, Draws& draws) {
  const double crown_height = s.height_m - s.trunk_height_m;
  const Vec3 centre(0, s.trunk_height_m + crown_height * 0.5, 0);
  std::vector<Vec3> twigs;                                          // ends of twigs, where leaves grow
  const double fine = std::min(1.0, 0.4 + 0.3 * s.crown_radius_m);  // small crowns have short twigs
  for (int i = 0; i < s.limbs; ++i) {
    const double t = (i + draws.uniform(0.2, 0.8)) / s.limbs;
    const double around = 2.4 * i + draws.uniform(-0.5, 0.5);  // about the golden angle
    const double reach = crown_profile(s, std::min(0.95, t * 0.9 + 0.08)) * draws.uniform(0.65, 0.9);
    const Vec3 root(0, s.trunk_height_m + crown_height * t * 0.62, 0);
    const Vec3 tip(std::cos(around) * reach, s.trunk_height_m + crown_height * (t * 0.85 + 0.1),
                   std::sin(around) * reach);
    Vec3 middle;
    add_bent_tube(mesh.surfaces[bark], root, tip, s.trunk_radius_m * 0.45 * (1 - 0.5 * t), 0.02, 5, draws,
                  &middle);
    for (int k = 0; k < 3; ++k) {
      const Vec3 from = middle + (tip - middle) * draws.uniform(0.0, 0.7);
      const Vec3 to =
          from + (random_direction(draws) + Vec3(0, 0.5, 0)).normalized() * draws.uniform(0.5, 1.1) * fine;
      add_tube(mesh.surfaces[bark], from, to, 0.022, 0.008, 3, false, bark_tile_m);
      twigs.push_back(to);
    }
    twigs.push_back(tip);
  }
  // Clumps: leaves gather around twigs and around points on the crown's outer shell.
  for (int i = 0; i < s.limbs * 5; ++i) {
    const double t = draws.uniform(0.02, 0.98), around = draws.uniform(0, 2 * pi);
    const double reach = crown_profile(s, t) * draws.uniform(0.72, 0.98);
    twigs.emplace_back(std::cos(around) * reach, s.trunk_height_m + crown_height * t,
                       std::sin(around) * reach);
  }
  Surface& surface = mesh.surfaces[leaves];
  for (int i = 0; i < s.cards; ++i) {
    const Vec3& twig = twigs[i % twigs.size()];
    const Vec3 at = twig + random_direction(draws) * (0.62 * fine * std::cbrt(draws.uniform(0, 1)));
    Vec3 outwards = at - centre;
    outwards.y() /= std::max(1.0, crown_height / (2 * s.crown_radius_m));
    outwards.normalize();
    const Vec3 strives = outwards * (0.8 * (1 - s.droop)) - Vec3(0, 1.4 * s.droop, 0);
    const Vec3 up = (strives + random_direction(draws)).normalized();
    const Vec3 facing = (outwards + random_direction(draws) * 0.9).normalized();
    add_card(surface, at, up, facing, draws.uniform(0.42, 0.7) * fine, {twig, outwards});
  }
}

void add_whorled_crown(Mesh& mesh, const TreeSpecies& s, MaterialId needles, MaterialId bark, Draws& draws) {
  const double crown_height = s.height_m - s.trunk_height_m;
  const int whorls = s.limbs;
  for (int w = 0; w < whorls; ++w) {
    const double t = (w + draws.uniform(0.0, 0.6)) / whorls;
    const double reach = crown_profile(s, t) * draws.uniform(0.85, 1.05) + 0.15;
    const int branches = std::max(4, static_cast<int>(9 * (1 - t) + 3));
    for (int b = 0; b < branches; ++b) {
      const double around = 2 * pi * (b + draws.uniform(0, 0.7)) / branches + w;
      const Vec3 out(std::cos(around), 0, std::sin(around));
      const Vec3 root(0, s.trunk_height_m + crown_height * t, 0);
      const Vec3 tip = root + out * reach + Vec3(0, -reach * draws.uniform(0.1, 0.35), 0);
      add_tube(mesh.surfaces[bark], root, tip, 0.035, 0.006, 3, false, bark_tile_m);
      const int cards = std::max(2, static_cast<int>(reach / 0.3));
      for (int c = 0; c < cards; ++c) {
        const Vec3 at = root + (tip - root) * ((c + 0.3) / cards);
        const Vec3 up = ((tip - root).normalized() + random_direction(draws) * 0.35).normalized();
        const Vec3 facing = (Vec3(0, 1, 0) + random_direction(draws) * 0.7).normalized();
        add_card(mesh.surfaces[needles], at, up, facing, draws.uniform(0.6, 0.9),
                 {at - Vec3(0, 0.2, 0), (out + Vec3(0, 0.7, 0)).normalized()});
      }
    }
  }
}

}  // namespace

const std::vector<TreeSpecies>& tree_species() {
  static const std::vector<TreeSpecies> species{
      {"lime", 11.0, 2.7, 3.1, 0.19, false, 0.40, 12, 1500},
      {"maple", 8.5, 2.3, 2.9, 0.15, false, 0.50, 10, 1200},
      {"plane", 14.0, 3.4, 4.2, 0.26, false, 0.55, 14, 2100},
      {"hornbeam", 8.0, 2.2, 1.7, 0.12, false, 0.45, 10, 900},
      {"young", 5.2, 2.0, 1.2, 0.06, false, 0.50, 7, 420},
      {"shrub", 1.9, 0.25, 1.0, 0.04, false, 0.50, 6, 320},
      {"spruce", 12.0, 0.8, 2.6, 0.18, true, 0, 18, 0, Foliage::needles},
      {"poplar", 19.0, 1.6, 1.5, 0.24, false, 0.35, 22, 1700, Foliage::fine},
      {"birch", 11.5, 2.6, 2.2, 0.12, false, 0.35, 13, 1200, Foliage::fine, Bark::birch, 0.8},
      {"pine", 12.0, 6.6, 2.9, 0.18, false, 0.30, 11, 900, Foliage::needles},
      {"globe", 4.4, 2.1, 1.25, 0.07, false, 0.50, 10, 620, Foliage::fine},
      {"plum", 5.4, 1.5, 1.9, 0.09, false, 0.40, 9, 800, Foliage::fine},
  };
  return species;
}

Mesh tree(const TreeSpecies& s, MaterialId leaves, MaterialId bark, Stream stream) {
  Mesh mesh{s.name, {}};
  Draws draws{stream};
  const double fork =
      s.whorled ? s.height_m * 0.98 : s.trunk_height_m + (s.height_m - s.trunk_height_m) * 0.65;
  Vec3 middle;
  add_tube(mesh.surfaces[bark], {0, -0.1, 0}, {0, 0.5, 0}, s.trunk_radius_m * 1.45, s.trunk_radius_m, 10,
           false, bark_tile_m);
  add_bent_tube(mesh.surfaces[bark], {0, 0.5, 0}, {0, fork, 0}, s.trunk_radius_m, s.trunk_radius_m * 0.25, 10,
                draws, &middle);
  if (s.whorled)
    add_whorled_crown(mesh, s, leaves, bark, draws);
  else
    add_broad_crown(mesh, s, leaves, bark, draws);
  return mesh;
}

Mesh hedge(const Materials& m, double length_m, double height_m, Stream stream) {
  Mesh mesh{"hedge", {}};
  Draws draws{stream};
  constexpr double half_width = 0.32;
  add_box(mesh.surfaces[m.hedge_core], {0, 0}, {1, 0}, length_m / 2 - 0.14, half_width - 0.13, -0.15,
          height_m - 0.16);
  Surface& surface = mesh.surfaces[m.leaves[1]];
  const auto add_leaves = [&](const Vec3& at, const Vec3& outwards) {
    const Vec3 up = (random_direction(draws) * 0.8 + Vec3(0, 0.5, 0) + outwards * 0.25).normalized();
    const Vec3 facing = (outwards + random_direction(draws) * 0.6).normalized();
    add_card(surface, at - up * 0.12, up, facing, draws.uniform(0.24, 0.36), {at - outwards * 0.2, outwards});
  };
  for (int i = 0; i < 115 * length_m; ++i) {
    const double x = draws.uniform(-0.5, 0.5) * length_m, z = draws.uniform(-1, 1) * half_width;
    const double y = draws.uniform(0.0, height_m - 0.12), face = draws.uniform(0, 1), side = z > 0 ? 1 : -1;
    if (face < 0.27)
      add_leaves({x, height_m - 0.12, z}, {0, 1, 0});
    else if (face < 0.90)
      add_leaves({x, y, side * (half_width - 0.08)}, Vec3(0, 0.15, side).normalized());
    else
      add_leaves({(x > 0 ? 1 : -1) * (length_m / 2 - 0.08), y, z}, {x > 0 ? 1.0 : -1.0, 0, 0});
  }
  return mesh;
}

}  // namespace cps::city
