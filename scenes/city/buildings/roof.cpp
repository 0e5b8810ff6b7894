#include "scenes/city/buildings/roof.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/buildings/attic.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"

namespace cps::city {
namespace {

constexpr double overhang_m = 0.45, slab_m = 0.2;
constexpr double mansard_depth_m = 0.95, mansard_rise_m = 2.5;  // of its steep part

/// The rise of a slope per metre. Not by radians(), which rounds π / 180 first: cities keep their bytes.
double slope_of(const RoofPlan& plan) {
  return std::tan(plan.pitch_deg * std::numbers::pi / 180);
}

/// The closed cross-section of a roof slab: its top from front to back, then its underside from back to
/// front.
std::vector<ProfilePoint> slab(const std::vector<ProfilePoint>& top) {
  std::vector<ProfilePoint> section = top;
  for (auto p = top.rbegin(); p != top.rend(); ++p) section.push_back({p->depth, p->height - slab_m});
  section.push_back(top.front());
  return section;
}

void add_chimney(Mesh& mesh, const Vec2& at, const Vec2& along, double from, double top, const Materials& m) {
  add_box(mesh.surfaces[m.brick[0].material], at, along, 0.32, 0.28, from, top, m.brick[0].tile_m);
  add_box(mesh.surfaces[m.stone.material], at, along, 0.38, 0.34, top, top + 0.1, m.stone.tile_m, true);
}

void add_chimneys(Mesh& mesh, const Footprint& f, double eaves, double ridge, const Materials& m,
                  Draws& draws) {
  const Polyline line = f.line_at(f.depth_m * draws.uniform(0.55, 0.7));
  const int count = draws.integer(0, 2);
  for (int i = 0; i < count; ++i) {
    const Station at = station_at(line, length(line) * draws.uniform(0.12, 0.88));
    add_chimney(mesh, at.point, at.direction, eaves - 0.3, ridge + draws.uniform(0.3, 0.9), m);
  }
}

double add_gable(Mesh& mesh, const Footprint& f, double eaves, const RoofPlan& plan, const Materials& m) {
  const double slope = slope_of(plan), rise = slope * f.depth_m / 2;
  const std::vector<ProfilePoint> top{{-overhang_m, eaves - overhang_m * slope + slab_m},
                                      {f.depth_m / 2, eaves + rise + slab_m},
                                      {f.depth_m + overhang_m, eaves - overhang_m * slope + slab_m}};
  const Footprint roof = f.lengthened(plan.free_start ? 0.3 : 0, plan.free_end ? 0.3 : 0);
  const std::vector<ProfilePoint> section = slab(top);
  Surface& tiles = mesh.surfaces[plan.cover];
  add_loft(tiles, roof, {section[0], section[1], section[2]}, roof_tile_m);
  Surface& boards = mesh.surfaces[m.frame_white];
  add_loft(boards, roof, {section[2], section[3], section[4], section[5], section[0]}, 1);
  for (int i = 0; i < 2; ++i)  // the slab's thickness at the ends
    add_loft_ends(boards, roof, {section[i], section[i + 1], section[4 - i], section[5 - i]}, 1);
  add_loft_ends(mesh.surfaces[plan.wall.material], f,
                {{0, eaves}, {f.depth_m / 2, eaves + rise}, {f.depth_m, eaves}}, plan.wall.tile_m);
  if (plan.lived_under && plan.free_start && rise > 2.4) add_gable_window(mesh, f, false, eaves, rise, m);
  if (plan.lived_under && plan.free_end && rise > 2.4) add_gable_window(mesh, f, true, eaves, rise, m);
  return eaves + rise + slab_m;
}

double add_mansard(Mesh& mesh, const Footprint& f, double eaves, const RoofPlan& plan) {
  const double break_in = mansard_depth_m, break_up = mansard_rise_m, rise = 1.2;
  const std::vector<ProfilePoint> section{{0, eaves},
                                          {break_in, eaves + break_up},
                                          {f.depth_m / 2, eaves + break_up + rise},
                                          {f.depth_m - break_in, eaves + break_up},
                                          {f.depth_m, eaves}};
  add_loft(mesh.surfaces[plan.cover], f, section, roof_tile_m);
  add_loft_ends(mesh.surfaces[plan.wall.material], f, section, plan.wall.tile_m);
  return eaves + break_up + rise;
}

double add_hip(Mesh& mesh, const Footprint& f, double eaves, const RoofPlan& plan, const Materials& m) {
  const double slope = slope_of(plan);
  const Footprint wide = f.lengthened(overhang_m, overhang_m);
  const Polyline front = wide.line_at(-overhang_m), back = wide.line_at(f.depth_m + overhang_m);
  const double half = f.depth_m / 2 + overhang_m, base = eaves - overhang_m * slope,
               ridge = base + half * slope;
  const Vec2 along = (front[1] - front[0]).normalized();
  const double inset = std::min(half, (front[1] - front[0]).norm() / 2 - 0.05);
  const Vec2 r0 = (front[0] + back[0]) / 2 + along * inset, r1 = (front[1] + back[1]) / 2 - along * inset;
  const auto face = [&](const std::vector<Vec3>& corners) {
    const Vec3 eave = (corners[1] - corners[0]).normalized();
    std::vector<Vertex> polygon;
    for (const Vec3& p : corners) {
      const Vec3 d = p - corners[0];
      const double u = d.dot(eave), v = (d - eave * u).norm();
      polygon.push_back({p, Vec2(u, -v) / roof_tile_m});
    }
    add_polygon(mesh.surfaces[plan.cover], polygon);
  };
  const Vec3 a = lift(front[0], base), b = lift(front[1], base), c = lift(back[1], base),
             d = lift(back[0], base);
  const Vec3 p = lift(r0, ridge), q = lift(r1, ridge);
  face({a, b, q, p});
  face({c, d, p, q});
  face({b, c, q});
  face({d, a, p});
  add_quad(mesh.surfaces[m.frame_white], {d}, {c}, {b}, {a});  // soffit
  return ridge;
}

double add_flat(Mesh& mesh, const Footprint& f, double eaves, const RoofPlan& plan, const Materials& m,
                Draws& draws) {
  const double top = eaves + parapet_m;
  Polygon outer = f.polygon();
  add_floor(mesh.surfaces[m.roof_flat], outer, eaves, flat_roof_tile_m);
  const std::vector<Vec2> inward = inward_miters(outer);
  Polygon inner = outer;
  for (std::size_t i = 0; i < outer.size(); ++i) inner[i] += inward[i] * 0.25;
  outer.push_back(outer.front());
  inner.push_back(inner.front());
  add_strip(mesh.surfaces[m.stone.material], inner, outer, {top, top, m.stone.tile_m});
  std::reverse(inner.begin(), inner.end());
  add_strip(mesh.surfaces[plan.wall.material], inner, inner, {top, eaves, plan.wall.tile_m});
  const Polyline middle = f.line_at(f.depth_m * 0.5);
  for (int i = plan.lived_under ? draws.integer(0, 3) : 0; i > 0; --i) {  // stair heads and ventilation
    const Station at = station_at(middle, length(middle) * draws.uniform(0.2, 0.8));
    add_box(mesh.surfaces[draws.chance(0.5) ? m.concrete[0].material : m.roof_metal], at.point, at.direction,
            draws.uniform(0.5, 1.8), draws.uniform(0.5, 1.5), eaves, eaves + draws.uniform(0.7, 2.4), 3);
  }
  return top;
}

}  // namespace

double add_roof(Mesh& mesh, const Footprint& f, double eaves, const RoofPlan& plan, const Materials& m,
                Draws& draws) {
  if (plan.kind == RoofKind::flat) return add_flat(mesh, f, eaves, plan, m, draws);
  if (plan.kind == RoofKind::sawtooth) return add_sawtooth(mesh, f, eaves, plan, m);
  const double ridge = plan.kind == RoofKind::hip       ? add_hip(mesh, f, eaves, plan, m)
                       : plan.kind == RoofKind::mansard ? add_mansard(mesh, f, eaves, plan)
                                                        : add_gable(mesh, f, eaves, plan, m);
  const double slope = slope_of(plan);
  if (plan.dormers && plan.kind == RoofKind::mansard)
    add_dormers(mesh, f, eaves, mansard_rise_m / mansard_depth_m, 0.25, m, draws);
  else if (plan.dormers && plan.kind == RoofKind::gable && slope * f.depth_m / 2 > 2.9)
    add_dormers(mesh, f, eaves + slab_m, slope, 1.0, m, draws);
  if (plan.lived_under) add_chimneys(mesh, f, eaves, ridge, m, draws);
  return ridge;
}

}  // namespace cps::city
