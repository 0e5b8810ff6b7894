#include "scenes/city/streets/surface/road_markings.h"

#include <algorithm>

#include "scenes/city/draws.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

constexpr double line_width_m = 0.12, zebra_stripe_m = 0.5;

/// Paints on one segment; stations are metres from its first junction, offsets are to the left.
struct Painter {
  Surface& paint;
  const Polyline& centre;

  void line(double from, double to, double left_m, double width = line_width_m) const {
    if (to - from > 0.1)
      add_stripe(paint, offset(cut(centre, from, to), left_m), width, paint_height_m, paint_tile_m);
  }
  void dashes(double from, double to, double left_m, double dash, double gap,
              double width = line_width_m) const {
    for (double s = from; s + dash <= to; s += dash + gap) line(s, s + dash, left_m, width);
  }
  void across(double station, double from_left, double to_left, double width) const {
    const Station at = station_at(centre, station);
    const Vec2 n = left_of(at.direction);
    add_stripe(paint, {at.point + n * from_left, at.point + n * to_left}, width, paint_height_m,
               paint_tile_m);
  }
  /// The give-way line: broad dashes across the lanes that lead into a roundabout, `from_middle_m` from its
  /// middle.
  void give_way(double from_middle_m, const StreetProfile& p, bool at_end) const {
    if ((at_end ? p.lanes_forward : p.lanes_backward) == 0) return;
    const double half = p.half_width(), total = length(centre);
    const double station = at_end ? total - from_middle_m : from_middle_m;
    const double low = at_end ? -half + p.edge_right_m() + 0.3 : p.divider_offset() + 0.2;
    const double high = at_end ? p.divider_offset() - 0.2 : half - p.edge_left_m() - 0.3;
    for (double left = low; left + 0.5 <= high; left += 0.75) across(station, left, left + 0.5, 0.5);
  }
  void zebra(double from, double to, double half_width) const {
    const int stripes = static_cast<int>((2 * half_width - 0.3) / (2 * zebra_stripe_m));
    for (int i = 0; i < stripes; ++i)
      line(from, to, (i - (stripes - 1) / 2.0) * 2 * zebra_stripe_m, zebra_stripe_m);
  }
};

/// The direction that an arrow marking shows.
enum class Arrow { straight, left, right };

/// Paints an arrow on the lane at offset `left_m`, its tip `ahead_m` before the stop line at `station`.
/// `with`: traffic runs in the line's direction.
void paint_arrow(const Painter& painter, double station, double left_m, bool with, double ahead_m,
                 Arrow arrow) {
  const Station at = station_at(painter.centre, station);
  const Vec2 on = with ? at.direction : Vec2(-at.direction), left = left_of(on);
  const Vec2 tip = at.point + left_of(at.direction) * left_m - on * ahead_m;
  const auto point = [&](double along, double aside) { return Vec2(tip + on * along + left * aside); };
  const auto triangle = [&](const Vec2& a, const Vec2& b, const Vec2& c) {
    std::vector<Vertex> corners;
    for (const Vec2& p : {a, b, c})
      corners.push_back({lift(p, paint_height_m), Vec2(p.x(), -p.y()) / paint_tile_m});
    add_polygon(painter.paint, corners);
  };
  const double shaft = arrow == Arrow::straight ? -1.4 : -0.75;
  add_stripe(painter.paint, {point(-4, 0), point(shaft, 0)}, 0.15, paint_height_m, paint_tile_m);
  if (arrow == Arrow::straight) return triangle(point(-1.4, 0.3), point(-1.4, -0.3), point(0, 0));
  const double side = arrow == Arrow::left ? 1 : -1;
  add_stripe(painter.paint, {point(-0.85, side * 0.076), point(-0.85, side * 0.45)}, 0.2, paint_height_m,
             paint_tile_m);
  const Vec2 a = point(-0.35, side * 0.45), b = point(-1.35, side * 0.45), c = point(-0.85, side * 1.05);
  side > 0 ? triangle(a, c, b) : triangle(a, b, c);
}

/// Paints an arrow per lane before a stop line, if there is more than one lane.
void paint_arrows(const Painter& painter, const StreetProfile& p, double station, bool with) {
  const int lanes = with ? p.lanes_forward : p.lanes_backward;
  for (int lane = 0; lane < lanes && lanes > 1; ++lane)
    paint_arrow(painter, station, with ? p.forward_lane_offset(lane) : p.backward_lane_offset(lane), with,
                4.0,
                lane == 0           ? Arrow::right
                : lane + 1 == lanes ? Arrow::left
                                    : Arrow::straight);
}

void paint_lanes(const Painter& painter, const StreetProfile& p, double from, double to) {
  const double divider = p.divider_offset();
  if (p.lanes_forward > 1 && p.lanes_backward > 1) {
    const double apart = p.median_m > 0 ? p.median_m / 2 + 0.25 : 0.12;
    painter.line(from, to, divider - apart);
    painter.line(from, to, divider + apart);
  } else if (p.lanes_backward > 0 && p.centre_line) {
    const double solid = std::min(12.0, (to - from) / 4);
    painter.line(from, from + solid, divider);
    painter.dashes(from + solid + 2, to - solid - 1, divider, 3, 4.5);
    painter.line(to - solid, to, divider);
  }
  for (int lane = 1; lane < p.lanes_forward; ++lane)
    painter.dashes(from, to, p.forward_lane_offset(lane) - p.lane_width_m / 2, 3, 6);
  for (int lane = 1; lane < p.lanes_backward; ++lane)
    painter.dashes(from, to, p.backward_lane_offset(lane) + p.lane_width_m / 2, 3, 6);
}

void paint_edges(const Painter& painter, const StreetProfile& p, double from, double to, bool bays,
                 bool edge_lines) {
  const double half = p.half_width();
  for (const auto& [side, parking, cycle] :
       {std::tuple{1.0, p.parking_left_m, p.cycle_left_m}, {-1.0, p.parking_right_m, p.cycle_right_m}}) {
    if (parking > 0 && bays) {
      painter.line(from, to, side * (half - parking), 0.1);
      for (double s = from; s <= to; s += 5.5)
        painter.across(s, side * (half - 0.3), side * (half - parking), 0.1);
    } else if (parking == 0 && cycle == 0 && edge_lines) {
      painter.line(from, to, side * (half - 0.42));
    }
  }
}

}  // namespace

Approach approach(const StreetNetwork& network, int segment, bool at_end, std::uint64_t seed) {
  Draws draws{substream(make_stream(seed, "approach"), 2 * segment + at_end)};
  const Segment& s = network.segments[segment];
  const StreetProfile& profile = network.streets[s.street].profile;
  const bool meets_road = (at_end ? s.cut_to : s.cut_from) > 0;
  Approach a;
  a.crossing = meets_road && draws.chance(profile.kind == "residential" ? 0.3 : 0.65);
  a.crossing_length_m = draws.uniform(3.0, 4.0);
  a.stop_line = meets_road && (a.crossing || draws.chance(0.6));
  if (network.junctions[at_end ? s.to : s.from].roundabout)
    a.stop_line = false;  // a roundabout has a give-way line instead
  a.stop_line_at_m = a.crossing ? a.crossing_from_m + a.crossing_length_m + 1.0 : 0.6;
  a.clear_m = meets_road ? (a.crossing ? a.stop_line_at_m + 4.0 : 5.0) : 0.0;
  return a;
}

Mesh road_markings(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed) {
  Mesh mesh{"markings " + network.streets[street].name, {}};
  const StreetProfile& profile = network.streets[street].profile;
  Draws draws{substream(make_stream(seed, "markings"), street)};
  const bool bays = draws.chance(0.5), edge_lines = profile.centre_line && draws.chance(0.6);
  Surface& paint = mesh.surfaces[materials.road_paint];
  for (int s : network.streets[street].segments) {
    const Segment& segment = network.segments[s];
    const double total = length(segment.centre);
    const Painter painter{paint, segment.centre};
    const Approach first = approach(network, s, false, seed), last = approach(network, s, true, seed);
    const double half = profile.half_width(), divider = profile.divider_offset(),
                 beside = profile.median_m / 2 + 0.1;
    if (first.crossing)
      painter.zebra(segment.cut_from + first.crossing_from_m,
                    segment.cut_from + first.crossing_from_m + first.crossing_length_m, half);
    if (last.crossing)
      painter.zebra(total - segment.cut_to - last.crossing_from_m - last.crossing_length_m,
                    total - segment.cut_to - last.crossing_from_m, half);
    const double stop_from = segment.cut_from + first.stop_line_at_m + stop_line_width_m / 2;
    const double stop_to = total - segment.cut_to - last.stop_line_at_m - stop_line_width_m / 2;
    if (first.stop_line && profile.lanes_backward > 0)
      painter.across(stop_from, half - profile.parking_left_m - 0.15, divider + beside, stop_line_width_m);
    if (last.stop_line && profile.lanes_forward > 0)
      painter.across(stop_to, divider - beside, -half + profile.parking_right_m + 0.15, stop_line_width_m);
    for (const bool at_end : {false, true})
      if (const auto& ring = network.junctions[at_end ? segment.to : segment.from].roundabout)
        painter.give_way(ring->outer_m + 0.4, profile, at_end);
    if (first.stop_line) paint_arrows(painter, profile, stop_from, false);
    if (last.stop_line) paint_arrows(painter, profile, stop_to, true);
    const double from = first.stop_line ? stop_from + stop_line_width_m / 2 : segment.cut_from + 0.5;
    const double to = last.stop_line ? stop_to - stop_line_width_m / 2 : total - segment.cut_to - 0.5;
    paint_lanes(painter, profile, from, to);
    paint_edges(painter, profile, segment.cut_from + first.clear_m, total - segment.cut_to - last.clear_m,
                bays, edge_lines);
  }
  if (paint.indices.empty()) mesh.surfaces.clear();
  return mesh;
}

}  // namespace cps::city
