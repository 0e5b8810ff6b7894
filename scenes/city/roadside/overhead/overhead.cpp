#include "scenes/city/roadside/overhead/overhead.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/draws.h"
#include "scenes/city/roadside/overhead/wire.h"
#include "scenes/city/streets/surface/heights.h"
#include "scenes/city/streets/surface/road_markings.h"

namespace cps::city {
namespace {

constexpr double mast_inset_m = 0.45, telegraph_spacing_m = 34, span_spacing_m = 30, tram_spacing_m = 27,
                 max_span_m = 60;
constexpr double crossarm_m = 7.9, insulator_m = 0.16, telephone_m = 6.6, span_height_m = 7.4;
constexpr double wires_m[] = {-0.7, -0.3, 0.3, 0.7};  ///< positions along the crossarm
constexpr double wire_radius_m = 0.007, cable_radius_m = 0.013;
/// Sag of a telegraph wire at the usual spacing; it grows with the square of the span.
constexpr double sag_m = 0.45;

OverheadKind draw_kind(Draws& draws, CityStyle style, const StreetProfile& profile) {
  if (style == CityStyle::mixed) style = static_cast<CityStyle>(draws.integer(0, 3));
  const bool narrow = profile.half_width() < 9;
  switch (style) {
    case CityStyle::european:
      return narrow && draws.chance(0.35) ? OverheadKind::span : OverheadKind::none;
    case CityStyle::downtown:
      return narrow && draws.chance(0.3) ? OverheadKind::span : OverheadKind::none;
    case CityStyle::suburb:
      return draws.chance(0.55) ? OverheadKind::telegraph : OverheadKind::none;
    case CityStyle::industrial:
      return draws.chance(0.4) ? OverheadKind::telegraph : OverheadKind::none;
    case CityStyle::mixed:
      break;
  }
  return OverheadKind::none;
}

Mast mast_at(const StreetNetwork& network, int segment, bool reversed, double station) {
  const Segment& s = network.segments[segment];
  const Station at = station_at(s.centre, station);
  const Vec2 inwards = left_of(at.direction) * (reversed ? -1.0 : 1.0);
  return {{segment, reversed},
          at.point + inwards * (s.half_width + mast_inset_m),
          std::atan2(-inwards.y(), -inwards.x())};
}

/// A point at a mast, `out` metres towards the carriageway and `height` above the pavement.
Vec3 on_mast(const Mast& mast, double out, double height) {
  const Vec2 facing(std::cos(mast.heading_rad), std::sin(mast.heading_rad));
  return lift(mast.position + facing * out, kerb_height_m + height);
}

void add_telegraph_span(Mesh& mesh, const Materials& m, const Mast& from, const Mast& to) {
  const double span = (to.position - from.position).norm();
  if (span > max_span_m) return;
  const double sag = sag_m * span * span / (telegraph_spacing_m * telegraph_spacing_m);
  Surface& cable = mesh.surfaces[m.cable];
  for (const double x : wires_m)
    add_wire(cable, on_mast(from, x, crossarm_m + insulator_m), on_mast(to, x, crossarm_m + insulator_m), sag,
             wire_radius_m);
  add_wire(cable, on_mast(from, 0.13, telephone_m), on_mast(to, 0.13, telephone_m), 1.3 * sag,
           cable_radius_m);
}

void add_span_with_lamp(Mesh& mesh, const Materials& m, const Mast& left, const Mast& right) {
  constexpr double sag = 0.3;
  const Vec3 from = on_mast(left, 0.05, span_height_m), to = on_mast(right, 0.05, span_height_m);
  add_wire(mesh.surfaces[m.cable], from, to, sag, cable_radius_m);
  const Vec3 middle = (from + to) / 2 - Vec3(0, sag, 0);
  const Vec2 plan(middle.x(), -middle.z()), across = (right.position - left.position).normalized();
  add_tube(mesh.surfaces[m.pole], middle, middle - Vec3(0, 0.3, 0), 0.012, 0.012, 6);
  add_box(mesh.surfaces[m.pole], plan, across, 0.36, 0.13, middle.y() - 0.42, middle.y() - 0.3, 1, true);
  add_box(mesh.surfaces[m.lamp_glass], plan, across, 0.3, 0.1, middle.y() - 0.47, middle.y() - 0.42, 1, true);
}

}  // namespace

Overhead overhead_along(const StreetNetwork& network, int segment, const CityOptions& options) {
  const Segment& s = network.segments[segment];
  Draws draws{substream(make_stream(options.seed, "overhead"), s.street)};
  const StreetProfile& profile = network.streets[s.street].profile;
  Overhead overhead{profile.tram_tracks ? OverheadKind::tram : draw_kind(draws, options.style, profile), {}};
  if (overhead.kind == OverheadKind::none) return overhead;
  const bool reversed = draws.chance(0.5);
  constexpr double room_m = 1.5;  // distance from signs
  const double from = s.cut_from + approach(network, segment, false, options.seed).clear_m + room_m,
               to = length(s.centre) - s.cut_to - approach(network, segment, true, options.seed).clear_m -
                    room_m;
  if (to - from < 10) return overhead;
  const bool telegraph = overhead.kind == OverheadKind::telegraph;
  const double spacing_m = telegraph                             ? telegraph_spacing_m
                           : overhead.kind == OverheadKind::tram ? tram_spacing_m
                                                                 : span_spacing_m;
  const int pieces = std::max(1, static_cast<int>(std::lround((to - from) / spacing_m)));
  for (int i = 0; i <= pieces; ++i) {
    const double station = from + (to - from) * i / pieces;
    if (telegraph) {
      overhead.masts.push_back(mast_at(network, segment, reversed, station));
    } else {
      overhead.masts.push_back(mast_at(network, segment, false, station));
      overhead.masts.push_back(mast_at(network, segment, true, station));
    }
  }
  return overhead;
}

Mesh overhead_wires(const StreetNetwork& network, int street, const Materials& materials,
                    const CityOptions& options) {
  Mesh mesh{"wires " + network.streets[street].name, {}};
  std::vector<Mast> row;  // telegraph wires continue across junctions
  for (const int segment : network.streets[street].segments) {
    const Overhead overhead = overhead_along(network, segment, options);
    const std::vector<Mast>& masts = overhead.masts;
    if (overhead.kind == OverheadKind::telegraph)
      row.insert(row.end(), masts.begin(), masts.end());
    else if (overhead.kind == OverheadKind::span)
      for (std::size_t i = 0; i + 1 < masts.size(); i += 2)
        add_span_with_lamp(mesh, materials, masts[i], masts[i + 1]);
  }
  for (std::size_t i = 0; i + 1 < row.size(); ++i) add_telegraph_span(mesh, materials, row[i], row[i + 1]);
  return mesh;
}

Mesh telegraph_mast(const Materials& m) {
  Mesh mesh{"telegraph mast", {}};
  Surface& wood = mesh.surfaces[m.mast_wood];
  add_tube(wood, {0, -0.05, 0}, {0, crossarm_m + 0.35, 0}, 0.14, 0.09, 12, true);
  add_block(wood, {-0.85, crossarm_m - 0.06, -0.05}, {0.85, crossarm_m + 0.06, 0.05});
  for (const double x : wires_m)
    add_tube(mesh.surfaces[m.sign_white], {x, crossarm_m + 0.05, 0}, {x, crossarm_m + insulator_m + 0.01, 0},
             0.035, 0.025, 8, true);
  add_tube(mesh.surfaces[m.pole], {0, 5.9, 0}, {1.3, 6.25, 0}, 0.025, 0.025, 8, true);
  add_box(mesh.surfaces[m.pole], {1.5, 0}, {1, 0}, 0.3, 0.11, 6.2, 6.3, 1, true);
  add_box(mesh.surfaces[m.lamp_glass], {1.52, 0}, {1, 0}, 0.22, 0.09, 6.16, 6.2, 1, true);
  return mesh;
}

Mesh span_mast(const Materials& m) {
  Mesh mesh{"span mast", {}};
  add_tube(mesh.surfaces[m.pole], {0, -0.05, 0}, {0, 1.2, 0}, 0.11, 0.11, 12);
  add_tube(mesh.surfaces[m.pole], {0, 1.2, 0}, {0, span_height_m + 0.15, 0}, 0.09, 0.06, 12, true);
  return mesh;
}

}  // namespace cps::city
