#include "scenes/city/streets/junctions.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/draws.h"
#include "scenes/city/streets/roundabout.h"

namespace cps::city {
namespace {

/// The corner between two kerb lines that meet at a junction.
struct Corner {
  Vec2 point, direction_in, direction_out;
  double turn = 0;
};

Corner corner_between(const Polyline& in, const Polyline& out) {
  Corner corner;
  corner.direction_in = (in[in.size() - 1] - in[in.size() - 2]).normalized();
  corner.direction_out = (out[1] - out[0]).normalized();
  const double sine = cross(corner.direction_in, corner.direction_out);
  corner.turn = std::atan2(sine, corner.direction_in.dot(corner.direction_out));
  if (std::abs(corner.turn) < straight_on_rad)
    corner.point = (in.back() + out.front()) / 2;
  else
    corner.point =
        in.back() + corner.direction_in * (cross(out.front() - in.back(), corner.direction_out) / sine);
  return corner;
}

constexpr int arc_steps = 8;  // of a rounded kerb

bool is_rounded(const StreetNetwork& network, const Side& in, const Side& out, const Corner& corner) {
  return network.is_road(in) && network.is_road(out) && corner.turn > straight_on_rad;
}

/// The border of a block around the corner between its sides `in` and `out`.
Polyline corner_line(const StreetNetwork& network, const Side& in, const Side& out, const Polyline& in_line,
                     const Polyline& out_line, double shrink_m) {
  const Junction& junction = network.junctions[network.end(in)];
  if (junction.roundabout)
    return around_roundabout(*junction.roundabout, junction.position, in_line, out_line, shrink_m);
  const Corner corner = corner_between(in_line, out_line);
  if (!is_rounded(network, in, out, corner)) return {corner.point};
  return fillet(corner.point, corner.direction_in, corner.direction_out,
                std::max(0.0, network.corner_radius(in) - shrink_m), arc_steps);
}

double& cut_of(StreetNetwork& network, const Side& arm) {
  Segment& segment = network.segments[arm.segment];
  return arm.reversed ? segment.cut_to : segment.cut_from;
}

}  // namespace

void shape_junctions(StreetNetwork& network, const CityOptions& options) {
  const Stream roundabouts = make_stream(options.seed, "roundabouts");
  Draws city_wide{substream(roundabouts, 0)};
  const double roundabout_share = draw_roundabout_share(options.style, city_wide);
  for (std::size_t j = 0; j < network.junctions.size(); ++j) {
    Junction& junction = network.junctions[j];
    Draws draws{substream(make_stream(options.seed, "junction"), j)};
    junction.radii.assign(junction.arms.size(), 0);
    Draws own{substream(roundabouts, 1 + j)};
    junction.roundabout = draw_roundabout(network, static_cast<int>(j), roundabout_share, own);
    if (junction.roundabout) {
      for (const Side& arm : junction.arms)
        cut_of(network, arm) =
            roundabout_cut_m(*junction.roundabout, network.segments[arm.segment].half_width);
      continue;
    }
    for (std::size_t i = 0; i < junction.arms.size(); ++i) {
      const Side out = junction.arms[(i + 1) % junction.arms.size()];
      const Side in = junction.arms[i];
      const double radius = draws.uniform(4.5, 8.0);
      // The border of the block between them arrives on arm i + 1 (against the arm's direction) and leaves on
      // arm i.
      const Corner corner =
          corner_between(network.kerb_line({out.segment, !out.reversed}), network.kerb_line(in));
      if (!is_rounded(network, in, out, corner)) continue;
      junction.radii[i] = radius;
      const double tangent = radius * std::tan(corner.turn / 2);
      for (const auto& [side, direction] :
           {std::pair{out, Vec2(-corner.direction_in)}, std::pair{in, corner.direction_out}}) {
        const double station = (corner.point + direction * tangent - junction.position).dot(direction);
        double& cut = cut_of(network, side);
        cut = std::max(cut, station);
      }
    }
  }
}

Polygon junction_border(const StreetNetwork& network, int junction) {
  const std::vector<Side>& arms = network.junctions[junction].arms;
  Polygon border;
  if (std::none_of(arms.begin(), arms.end(), [&](const Side& arm) { return network.is_road(arm); }))
    return border;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const Side arm = arms[i], next = arms[(i + 1) % arms.size()];
    if (network.is_road(arm)) {
      const Segment& segment = network.segments[arm.segment];
      const Station at = station_at(network.line(arm, 0), arm.reversed ? segment.cut_to : segment.cut_from);
      border.push_back(at.point - left_of(at.direction) * segment.half_width);
      border.push_back(at.point + left_of(at.direction) * segment.half_width);
    }
    // The block's border runs the other way: it arrives on the next arm and leaves on this one.
    const Side arrives{next.segment, !next.reversed};
    const Polyline corner =
        corner_line(network, arrives, arm, network.kerb_line(arrives), network.kerb_line(arm), 0);
    border.insert(border.end(), corner.rbegin(), corner.rend());
  }
  return border;
}

Outline outline(const StreetNetwork& network, const Block& block, const std::vector<double>& inset_m,
                double corner_shrink_m) {
  const std::size_t n = block.sides.size();
  std::vector<Polyline> lines(n);
  for (std::size_t i = 0; i < n; ++i) lines[i] = network.kerb_line(block.sides[i], inset_m[i]);
  std::vector<Polyline> arcs(n);  // at the end of side i
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    arcs[i] = corner_line(network, block.sides[i], block.sides[next], lines[i], lines[next], corner_shrink_m);
  }
  Outline result;
  const auto add = [&](const Vec2& point, std::size_t side, bool corner) {
    result.points.push_back(point);
    result.side.push_back(static_cast<int>(side));
    result.corner.push_back(corner);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 1; k + 1 < lines[i].size(); ++k) add(lines[i][k], i, false);
    for (std::size_t k = 0; k + 1 < arcs[i].size(); ++k) add(arcs[i][k], i, true);
    add(arcs[i].back(), (i + 1) % n, false);
  }
  return result;
}

}  // namespace cps::city
