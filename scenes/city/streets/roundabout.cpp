#include "scenes/city/streets/roundabout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps::city {
namespace {

using std::numbers::pi;
constexpr int fillet_steps = 6, ring_steps = 16;

double angle_of(const Vec2& v) {
  return std::atan2(v.y(), v.x());
}

double sweep(const Vec2& centre, const Vec2& from, const Vec2& to) {
  return std::atan2(cross(from - centre, to - centre), (from - centre).dot(to - centre));
}

/// The arc that touches both a line leading to the ring and the ring itself.
struct Fillet {
  Vec2 centre, on_line, on_ring;
};

/// `aside` points from the line to the arc's centre, `on` along the line towards the ring (both unit).
Fillet fillet_to_ring(const Vec2& middle, double ring_m, const Vec2& on_line, const Vec2& on,
                      const Vec2& aside, double radius_m) {
  const double lateral = aside.dot(on_line - middle) + radius_m, reach = ring_m + radius_m;
  const double along = std::sqrt(std::max(0.0, reach * reach - lateral * lateral));
  const Vec2 centre = middle + aside * lateral - on * along;
  return {centre, centre - aside * radius_m, middle + (centre - middle) * (ring_m / reach)};
}

Fillet kerb_fillet(const Roundabout& r, const Vec2& middle, const Vec2& on_line, const Vec2& on,
                   const Vec2& aside, double inset_m) {
  return fillet_to_ring(middle, r.outer_m + inset_m, on_line, on, aside, std::max(0.0, r.fillet_m - inset_m));
}

Station last_station(const Polyline& line) {
  return {line.back(), (line.back() - line[line.size() - 2]).normalized()};
}

Station first_station(const Polyline& line) {
  return {line[0], (line[1] - line[0]).normalized()};
}

/// The angle that the ring's kerb covers between two arms; negative if they are too close together.
double ring_between(const Roundabout& r, const Vec2& middle, const Polyline& arriving,
                    const Polyline& leaving, double inset_m) {
  const Station in = last_station(arriving), out = first_station(leaving);
  const Vec2 a = kerb_fillet(r, middle, in.point, in.direction, left_of(in.direction), inset_m).on_ring,
             b = kerb_fillet(r, middle, out.point, -out.direction, left_of(out.direction), inset_m).on_ring;
  const double between =
      angle_of(a - middle) - angle_of(b - middle);  // clockwise, as the block's border runs
  return std::remainder(between - pi, 2 * pi) + pi;
}

}  // namespace

double draw_roundabout_share(CityStyle style, Draws& draws) {
  const bool none = draws.chance(0.35);
  const double share = draws.uniform(0.1, style == CityStyle::industrial ? 0.6 : 0.4);
  return none ? 0 : share;
}

std::optional<Roundabout> draw_roundabout(const StreetNetwork& network, int junction, double share,
                                          Draws& draws) {
  const bool wanted = draws.chance(share);
  Roundabout r;
  r.outer_m = draws.uniform(13.5, 17);
  r.island_m = r.outer_m - draws.uniform(5.5, 6.8);
  r.fillet_m = draws.uniform(6, 9);
  const Junction& j = network.junctions[junction];
  if (!wanted || j.arms.size() < 3) return std::nullopt;
  if (std::any_of(j.arms.begin(), j.arms.end(), [&](const Side& arm) {
        return network.is_road(arm) &&
               std::max(network.profile(arm).lanes_forward, network.profile(arm).lanes_backward) == 2;
      })) {
    constexpr double second_lane_m = 3.4;
    r.lanes = 2;
    r.outer_m += second_lane_m + 1;
    r.island_m += 1;
    r.fillet_m += 1;
  }
  for (std::size_t i = 0; i < j.arms.size(); ++i) {
    const Side arm = j.arms[i], next = j.arms[(i + 1) % j.arms.size()];
    if (!network.is_road(arm) || network.junctions[network.end(arm)].roundabout) return std::nullopt;
    const StreetProfile& p = network.profile(arm);
    const double cut_m = roundabout_cut_m(r, p.half_width());
    if (std::max(p.lanes_forward, p.lanes_backward) > 2 || p.median_m > 0 || p.tram_tracks ||
        cut_m > 0.33 * length(network.segments[arm.segment].centre))
      return std::nullopt;
    if (!network.is_road(next)) return std::nullopt;
    for (const double inset_m : {0.0, std::max(p.pavement_m, network.profile(next).pavement_m)}) {
      const double ring_rad =
          ring_between(r, j.position, network.kerb_line({next.segment, !next.reversed}, inset_m),
                       network.kerb_line(arm, inset_m), inset_m);
      if (ring_rad < 0.1 || ring_rad > 1.5 * pi) return std::nullopt;
    }
  }
  return r;
}

double roundabout_cut_m(const Roundabout& r, double half_width_m) {
  constexpr double margin_m = 1.5;  // the lanes' curves begin a little before the kerb's
  const double reach = r.outer_m + r.fillet_m, lateral = half_width_m + r.fillet_m;
  return std::sqrt(reach * reach - lateral * lateral) + margin_m;
}

Polyline around_roundabout(const Roundabout& r, const Vec2& middle, const Polyline& arriving,
                           const Polyline& leaving, double inset_m) {
  const Station in = last_station(arriving), out = first_station(leaving);
  const Fillet a = kerb_fillet(r, middle, in.point, in.direction, left_of(in.direction), inset_m),
               b = kerb_fillet(r, middle, out.point, -out.direction, left_of(out.direction), inset_m);
  Polyline line = arc(a.centre, a.on_line, sweep(a.centre, a.on_line, a.on_ring), fillet_steps);
  const double clockwise = ring_between(r, middle, arriving, leaving, inset_m);
  const Polyline ring = arc(middle, a.on_ring, -clockwise, ring_steps);
  line.insert(line.end(), ring.begin() + 1, ring.end());
  const Polyline last = arc(b.centre, b.on_ring, sweep(b.centre, b.on_ring, b.on_line), fillet_steps);
  line.insert(line.end(), last.begin() + 1, last.end());
  return line;
}

Polyline roundabout_way(const Roundabout& r, const Vec2& middle, const Station& from, const Station& to,
                        int lane) {
  constexpr double step_rad = 0.1;
  const double ring_m = r.lane_radius_m(std::min(lane, r.lanes - 1));
  // Three arcs: right into the ring, left around it, right out of it.
  const auto fillet_from = [&](const Vec2& end, const Vec2& on, const Vec2& aside) {
    // The largest radius whose arc begins no earlier than the lane's end.
    const double lateral = aside.dot(end - middle), room = on.dot(middle - end);
    const double widest =
        (room * room + lateral * lateral - ring_m * ring_m) / (2 * std::max(1e-3, ring_m - lateral));
    return fillet_to_ring(middle, ring_m, end, on, aside, std::min(r.fillet_m, widest));
  };
  const Fillet in = fillet_from(from.point, from.direction, -left_of(from.direction)),
               out = fillet_from(to.point, -to.direction, -left_of(to.direction));
  double around = sweep(middle, in.on_ring, out.on_ring);
  if (around < 0) around += 2 * pi;
  Polyline way{from.point};
  const auto add = [&](const Polyline& points) {
    for (const Vec2& p : points)
      if ((p - way.back()).norm() > 0.05) way.push_back(p);
  };
  const auto steps = [](double rad) {
    return std::max(1, static_cast<int>(std::ceil(std::abs(rad) / step_rad)));
  };
  const double enter = sweep(in.centre, in.on_line, in.on_ring),
               leave = sweep(out.centre, out.on_ring, out.on_line);
  add(arc(in.centre, in.on_line, enter, steps(enter)));
  add(arc(middle, in.on_ring, around, steps(around)));
  add(arc(out.centre, out.on_ring, leave, steps(leave)));
  if (way.size() > 1 && (to.point - way.back()).norm() < 0.05) way.pop_back();
  way.push_back(to.point);
  return way;
}

}  // namespace cps::city
