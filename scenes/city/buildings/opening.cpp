#include "scenes/city/buildings/opening.h"

#include <algorithm>

namespace cps::city {

WallFrame make_wall_frame(const Vec2& from, const Vec2& to) {
  const Vec2 along = (to - from).normalized();
  return {from, along, -left_of(along)};
}

Doorway doorway_of(const WallFrame& frame, const Opening& o) {
  return {frame.origin + frame.along * ((o.u0 + o.u1) / 2), frame.out, o.u1 - o.u0,
          o.kind == Opening::Kind::gate};
}

void add_panel(Surface& surface, const WallFrame& f, const WallRectangle& r, double w, double tile_m) {
  const auto& [u0, u1, z0, z1] = r;
  add_quad(surface, {f.point(u0, z0, w), {u0 / tile_m, -z0 / tile_m}},
           {f.point(u1, z0, w), {u1 / tile_m, -z0 / tile_m}},
           {f.point(u1, z1, w), {u1 / tile_m, -z1 / tile_m}},
           {f.point(u0, z1, w), {u0 / tile_m, -z1 / tile_m}});
}

namespace {

/// Adds the faces around a rectangle between two depths, facing away from its middle (`outwards`) or towards
/// it.
void add_rim(Surface& surface, const WallFrame& f, const WallRectangle& r, double w0, double w1,
             bool outwards, double tile_m, unsigned faces = all_faces) {
  const auto& [u0, u1, z0, z1] = r;
  const double a = outwards ? w0 : w1, b = outwards ? w1 : w0;
  const double ta = a / tile_m, tb = b / tile_m, v0 = -z0 / tile_m, v1 = -z1 / tile_m, s0 = u0 / tile_m,
               s1 = u1 / tile_m;
  if (faces & left_face)
    add_quad(surface, {f.point(u0, z0, a), {ta, v0}}, {f.point(u0, z0, b), {tb, v0}},
             {f.point(u0, z1, b), {tb, v1}}, {f.point(u0, z1, a), {ta, v1}});
  if (faces & right_face)
    add_quad(surface, {f.point(u1, z0, b), {tb, v0}}, {f.point(u1, z0, a), {ta, v0}},
             {f.point(u1, z1, a), {ta, v1}}, {f.point(u1, z1, b), {tb, v1}});
  if (faces & lower_face)
    add_quad(surface, {f.point(u0, z0, a), {s0, ta}}, {f.point(u1, z0, a), {s1, ta}},
             {f.point(u1, z0, b), {s1, tb}}, {f.point(u0, z0, b), {s0, tb}});
  if (faces & upper_face)
    add_quad(surface, {f.point(u0, z1, b), {s0, tb}}, {f.point(u1, z1, b), {s1, tb}},
             {f.point(u1, z1, a), {s1, ta}}, {f.point(u0, z1, a), {s0, ta}});
}

}  // namespace

void add_bar(Surface& surface, const WallFrame& f, const WallRectangle& r, double w0, double w1,
             double tile_m, unsigned faces) {
  add_panel(surface, f, r, w1, tile_m);
  add_rim(surface, f, r, w0, w1, true, tile_m, faces);
}

namespace {

/// Height of sills and thresholds above the lower side of the hole, which would otherwise be coplanar.
constexpr double sill_rise_m = 0.012;

/// Adds the flat ring between the opening's rectangle and that inset by `bar`, with shared vertices.
void add_ring(Surface& surface, const WallFrame& f, const Opening& o, double bar, double w) {
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  const Eigen::Vector3f normal = lift(f.out, 0).cast<float>();
  for (const double in : {0.0, bar})
    for (const auto& [u, z] : {std::pair{o.u0 + in, o.z0 + in},
                               {o.u1 - in, o.z0 + in},
                               {o.u1 - in, o.z1 - in},
                               {o.u0 + in, o.z1 - in}}) {
      surface.positions.push_back(f.point(u, z, w).cast<float>());
      surface.normals.push_back(normal);
      surface.uvs.emplace_back(0.f, 0.f);
    }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t a = first + i, b = first + (i + 1) % 4;
    surface.indices.insert(surface.indices.end(), {a, b, b + 4, a, b + 4, a + 4});
  }
}

/// Adds a frame `bar` metres wide around the opening and a pane behind it, both set back into the wall.
void add_sash(Mesh& mesh, const WallFrame& f, const Opening& o, double bar, double back, MaterialId frame,
              MaterialId pane, bool deep) {
  Surface& s = mesh.surfaces[frame];
  add_ring(s, f, o, bar, -back);
  const double glass = deep ? back + 0.04 : back;
  if (deep) add_rim(s, f, {o.u0 + bar, o.u1 - bar, o.z0 + bar, o.z1 - bar}, -glass, -back, false, 1);
  add_panel(mesh.surfaces[pane], f, {o.u0 + bar, o.u1 - bar, o.z0 + bar, o.z1 - bar}, -glass);
}

void add_window(Mesh& mesh, const WallFrame& f, const Opening& o, const FacadeStyle& style, Detail detail,
                const Materials& m, Draws& draws) {
  const double bar = 0.07, back = style.reveal_m;
  const bool curtained = draws.chance(style.curtain_share);
  add_sash(mesh, f, o, bar, back, style.frame, curtained ? m.curtained_glass : m.glass,
           detail == Detail::near_street);
  if (draws.chance(style.shutter_share)) {  // a roller shutter, partly lowered
    const double down = draws.chance(0.3) ? 1.0 : draws.uniform(0.15, 0.6);
    add_bar(mesh.surfaces[m.shutter], f, {o.u0, o.u1, o.z1 - down * (o.z1 - o.z0), o.z1}, -back, -back + 0.03,
            1, lower_face);
  }
  if (detail == Detail::plain) return;
  const bool deep = detail == Detail::near_street;
  const double pane = deep ? back + 0.04 : back;
  Surface& bars = mesh.surfaces[style.frame];
  for (int k = 1; k <= style.mullions; ++k) {
    const double u = o.u0 + (o.u1 - o.u0) * k / (style.mullions + 1);
    add_bar(bars, f, {u - 0.035, u + 0.035, o.z0 + bar, o.z1 - bar}, -pane, -back + 0.003, 1,
            deep ? left_face | right_face : no_faces);
  }
  if (style.transom) {
    const double z = o.z0 + (o.z1 - o.z0) * 0.68;
    add_bar(bars, f, {o.u0 + bar, o.u1 - bar, z - 0.03, z + 0.03}, -pane, -back + 0.004, 1,
            deep ? lower_face | upper_face : no_faces);
  }
  Surface& trim = mesh.surfaces[m.trim];
  add_bar(trim, f, {o.u0 - 0.06, o.u1 + 0.06, o.z0 - 0.05, o.z0 + sill_rise_m}, -back, 0.07, 1,
          deep ? all_faces : lower_face | upper_face);
  if (style.surrounds) {
    const double w = 0.14;
    add_bar(trim, f, {o.u0 - w, o.u0, o.z0, o.z1 + w}, 0, 0.035, 1, deep ? left_face : no_faces);
    add_bar(trim, f, {o.u1, o.u1 + w, o.z0, o.z1 + w}, 0, 0.035, 1, deep ? right_face : no_faces);
    add_bar(trim, f, {o.u0, o.u1, o.z1, o.z1 + w}, 0, 0.035, 1, deep ? lower_face : no_faces);
  }
}

void add_door(Mesh& mesh, const WallFrame& f, const Opening& o, const FacadeStyle& style, const Materials& m,
              Draws& draws) {
  constexpr double leaf_m = 2.08, back = 0.22;
  const MaterialId leaf = draws.chance(0.5) ? m.door_wood : m.door_dark;
  const double bar = 0.09, top = o.z0 + leaf_m;
  Surface& frame = mesh.surfaces[style.frame];
  add_bar(frame, f, {o.u0, o.u0 + bar, o.z0, o.z1}, -back - 0.05, -back);
  add_bar(frame, f, {o.u1 - bar, o.u1, o.z0, o.z1}, -back - 0.05, -back);
  add_bar(frame, f, {o.u0 + bar, o.u1 - bar, top, top + 0.07}, -back - 0.05, -back);
  add_panel(mesh.surfaces[leaf], f, {o.u0 + bar, o.u1 - bar, o.z0, top}, -back - 0.04);
  if (draws.chance(0.6))  // a pane in the leaf
    add_bar(mesh.surfaces[m.glass], f, {o.u0 + 0.3, o.u1 - 0.3, o.z0 + 1.1, top - 0.2}, -back - 0.04,
            -back - 0.03);
  add_bar(mesh.surfaces[m.rim], f, {o.u1 - bar - 0.14, o.u1 - bar - 0.1, o.z0 + 0.95, o.z0 + 1.2},
          -back - 0.04, -back + 0.01);
  add_panel(mesh.surfaces[m.glass], f, {o.u0 + bar, o.u1 - bar, top + 0.07, o.z1}, -back - 0.04);
  add_bar(mesh.surfaces[m.stone.material], f, {o.u0 - 0.1, o.u1 + 0.1, o.z0 - 0.1, o.z0 + sill_rise_m}, -back,
          0.3, m.stone.tile_m);
}

void add_shop_front(Mesh& mesh, const WallFrame& f, const Opening& o, const Materials& m) {
  constexpr double back = 0.12;
  Surface& frame = mesh.surfaces[m.frame_dark];
  add_bar(frame, f, {o.u0, o.u1, o.z0, o.z0 + 0.35}, -back, -back + 0.05);
  const int panes = std::max(1, static_cast<int>((o.u1 - o.u0) / 1.5));
  const double width = (o.u1 - o.u0) / panes;
  for (int k = 0; k < panes; ++k) {
    const Opening pane{Opening::Kind::window, o.u0 + k * width, o.u0 + (k + 1) * width, o.z0 + 0.35, o.z1};
    add_sash(mesh, f, pane, 0.05, back, m.frame_dark, m.glass, true);
  }
}

}  // namespace

void add_pierced_wall(Surface& surface, const WallFrame& frame, double width, double bottom, double top,
                      const std::vector<Opening>& openings, double tile_m) {
  double u = 0;
  for (const Opening& o : openings) {
    add_panel(surface, frame, {u, o.u0, bottom, top}, 0, tile_m);
    if (o.z0 > bottom) add_panel(surface, frame, {o.u0, o.u1, bottom, o.z0}, 0, tile_m);
    if (o.z1 < top) add_panel(surface, frame, {o.u0, o.u1, o.z1, top}, 0, tile_m);
    u = o.u1;
  }
  add_panel(surface, frame, {u, width, bottom, top}, 0, tile_m);
}

void add_gate(Mesh& mesh, const WallFrame& f, const Opening& o, MaterialId leaf, const Materials& m) {
  constexpr double back = 0.2, section_m = 0.52, jamb_m = 0.12;
  Surface& frame = mesh.surfaces[m.frame_dark];
  add_rim(frame, f, {o.u0, o.u1, o.z0, o.z1}, -back, 0, false, 1, left_face | right_face | upper_face);
  const int sections = std::max(1, static_cast<int>((o.z1 - o.z0) / section_m + 0.5));
  const double rise = (o.z1 - o.z0) / sections;
  for (int k = 0; k < sections; ++k) {
    const double z = o.z0 + k * rise;
    add_panel(mesh.surfaces[leaf], f, {o.u0, o.u1, z, z + rise}, -back);
    add_bar(mesh.surfaces[leaf], f, {o.u0 + jamb_m, o.u1 - jamb_m, z + 0.03, z + rise - 0.03}, -back,
            -back + 0.03, 1, lower_face | upper_face);
  }
}

void add_opening(Mesh& mesh, const WallFrame& f, const Opening& o, const FacadeStyle& style,
                 const WallMaterial& wall, Detail detail, const Materials& m, Draws& draws) {
  const double back = o.kind == Opening::Kind::door   ? 0.27
                      : o.kind == Opening::Kind::shop ? 0.12
                                                      : style.reveal_m;
  add_rim(mesh.surfaces[wall.material], f, {o.u0, o.u1, o.z0, o.z1}, -back, 0, false, wall.tile_m);
  switch (o.kind) {
    case Opening::Kind::window:
      return add_window(mesh, f, o, style, detail, m, draws);
    case Opening::Kind::door:
      return add_door(mesh, f, o, style, m, draws);
    case Opening::Kind::shop:
      return add_shop_front(mesh, f, o, m);
    case Opening::Kind::gate:
      return add_gate(mesh, f, o, m.shutter, m);
  }
}

}  // namespace cps::city
