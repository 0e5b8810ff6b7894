#include "scenes/city/streets/surface/junction_details.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/surface/heights.h"
#include "scenes/city/streets/surface/road_wear.h"

namespace cps::city {
namespace {

constexpr double junction_line_width_m = 0.12;

void add_dashes(Surface& paint, const Polyline& line, double dash_m, double gap_m, double width_m) {
  const double total = length(line);
  for (double s = gap_m; s + dash_m < total; s += dash_m + gap_m)
    add_stripe(paint, cut(line, s, s + dash_m), width_m, paint_height_m, paint_tile_m);
}

double turn_of(const Polyline& line) {
  const Vec2 in = line[1] - line[0], out = line.back() - line[line.size() - 2];
  return std::atan2(cross(in, out), in.dot(out));
}

/// Guide lines for left turns from multi-lane streets: the right edge of the lane, for each pair of streets
/// that of the tightest turn.
void add_turn_guides(Surface& paint, const StreetNetwork& network, int junction,
                     const std::vector<DrivingLane>& lanes) {
  std::map<std::pair<int, int>, const DrivingLane*> tightest;
  for (const DrivingLane& lane : lanes) {
    const StreetProfile& p = network.streets[lane.street].profile;
    if (lane.junction != junction || std::max(p.lanes_forward, p.lanes_backward) < 2 ||
        turn_of(lane.points) < 0.8)
      continue;
    const Vec2 from = lane.points.front() - network.junctions[junction].position;
    const int side = static_cast<int>(std::lround(std::atan2(from.y(), from.x()) * 2));  // which arm
    const DrivingLane*& best = tightest[{side, lanes[lane.next.front()].street}];
    if (!best || length(lane.points) < length(best->points)) best = &lane;
  }
  for (const auto& [ways, lane] : tightest)
    add_dashes(paint, offset(lane->points, -lane->width_m / 2), 1, 1, junction_line_width_m);
}

/// Continues the edge lines and cycle tracks of the street that runs through, across the mouths of the
/// streets that join it.
void add_through_lines(Surface& paint, const StreetNetwork& network, const Junction& junction) {
  const std::size_t n = junction.arms.size();
  const auto mouth = [&](const Side& arm) {
    const Segment& segment = network.segments[arm.segment];
    return station_at(network.line(arm, 0), arm.reversed ? segment.cut_to : segment.cut_from).point;
  };
  const auto lanes_of = [&](const Side& arm) {
    const StreetProfile& p = network.profile(arm);
    return p.lanes_forward + p.lanes_backward;
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const Side from = junction.arms[i], to = junction.arms[k];
      if (i == k || !network.is_road(from) || !network.is_road(to) || !from.reversed || to.reversed ||
          network.segments[from.segment].street != network.segments[to.segment].street)
        continue;
      const StreetProfile& p = network.profile(to);
      const Polyline through{mouth(from), junction.position, mouth(to)};
      for (const bool left : {true, false}) {
        // The arms on the left are those anticlockwise from the arm ahead to the one behind.
        const std::size_t first = left ? k : i, last = left ? i : k;
        int joining = 0;
        for (std::size_t a = (first + 1) % n; a != last; a = (a + 1) % n)
          if (network.is_road(junction.arms[a])) joining = std::max(joining, lanes_of(junction.arms[a]));
        if (joining == 0 || joining > lanes_of(to)) continue;
        const double cycle_m = left ? p.cycle_left_m : p.cycle_right_m,
                     edge_m = p.half_width() - (left ? p.edge_left_m() : p.edge_right_m());
        const double side = left ? 1 : -1;
        add_dashes(paint, offset(through, side * (edge_m - (cycle_m > 0 ? 0 : 0.2))), 0.5, 0.5,
                   cycle_m > 0 ? 0.25 : junction_line_width_m);
        if (cycle_m > 0) add_dashes(paint, offset(through, side * (edge_m + cycle_m - 0.2)), 0.5, 0.5, 0.25);
      }
    }
}

/// The dashed line between the two lanes of a wide roundabout.
void add_ring_line(Surface& paint, const Junction& junction) {
  constexpr int pieces = 72;
  const Roundabout& ring = *junction.roundabout;
  const double radius_m = (ring.outer_m + ring.island_m) / 2;
  Polyline circle;
  for (int i = 0; i <= pieces; ++i) {
    const double a = 2 * std::numbers::pi * i / pieces;
    circle.push_back(junction.position + radius_m * Vec2(std::cos(a), std::sin(a)));
  }
  add_dashes(paint, circle, 1, 2, junction_line_width_m);
}

}  // namespace

Mesh junction_details(const StreetNetwork& network, int index, const std::vector<DrivingLane>& lanes,
                      const Materials& materials, std::uint64_t seed) {
  Mesh mesh{"junction details", {}};
  const Junction& junction = network.junctions[index];
  const Polygon border = junction_border(network, index);
  if (border.empty()) return mesh;
  Draws draws{substream(make_stream(seed, "junction details"), index)};
  const double wear = draws.uniform(0.2, 2);
  const bool guided = draws.chance(0.7), lined = draws.chance(0.75);
  Surface paint;
  if (!junction.roundabout && guided) add_turn_guides(paint, network, index, lanes);
  if (!junction.roundabout && lined) add_through_lines(paint, network, junction);
  if (junction.roundabout && junction.roundabout->lanes > 1) add_ring_line(paint, junction);
  if (!paint.indices.empty()) mesh.surfaces[materials.road_paint] = std::move(paint);
  add_junction_wear(mesh, border, junction.position, junction.roundabout ? junction.roundabout->island_m : 0,
                    materials, wear, draws);
  return mesh;
}

}  // namespace cps::city
