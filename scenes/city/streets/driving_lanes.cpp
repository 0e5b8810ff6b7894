#include "scenes/city/streets/driving_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/city/streets/roundabout.h"

namespace cps::city {
namespace {

constexpr double straight_rad = 0.6;  ///< a smaller change of heading counts as straight on
constexpr double arc_step_rad = 0.1;

/// The lanes of a segment: [backward][number from the kerb].
using SegmentLanes = std::array<std::vector<int>, 2>;

struct LaneEnd {
  Vec2 point, direction;
};

LaneEnd end_of(const Polyline& line) {
  return {line.back(), (line[line.size() - 1] - line[line.size() - 2]).normalized()};
}

LaneEnd start_of(const Polyline& line) {
  return {line[0], (line[1] - line[0]).normalized()};
}

double heading_change(const LaneEnd& from, const LaneEnd& to) {
  return std::atan2(cross(from.direction, to.direction), from.direction.dot(to.direction));
}

/// A cubic Bézier curve with the directions of both ends, for links that hardly turn.
Polyline smooth_link(const LaneEnd& from, const LaneEnd& to) {
  constexpr int steps = 12;
  const double reach = 0.4 * (to.point - from.point).norm();
  const Vec2 b = from.point + from.direction * reach, c = to.point - to.direction * reach;
  Polyline line;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, s = 1 - t;
    line.push_back(s * s * s * from.point + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * to.point);
  }
  return line;
}

/// A straight line, one arc and a straight line; the arc as wide as possible, at most `max_radius_m`.
Polyline turn(const LaneEnd& from, const LaneEnd& to, double max_radius_m) {
  const double change = heading_change(from, to), sine = std::sin(change);
  const Vec2 between = to.point - from.point;
  const double before = cross(between, to.direction) / sine, after = cross(from.direction, between) / sine;
  if (std::abs(change) > 0.002 && std::abs(change) < 0.14 && std::min(before, after) > 1)
    return {from.point, from.point + from.direction * before, to.point};  // the street itself bends here
  if (std::abs(change) < 0.25 || std::abs(change) > 2.8 || std::min(before, after) < 1)
    return smooth_link(from, to);
  const double tangent = std::tan(std::abs(change) / 2);
  const double radius = std::min(max_radius_m, std::min(before, after) / tangent);
  const int steps = static_cast<int>(std::ceil(std::abs(change) / arc_step_rad));
  Polyline line{from.point};
  const auto add = [&](const Vec2& p) {
    if ((p - line.back()).norm() > 0.02) line.push_back(p);
  };
  for (const Vec2& p :
       fillet(from.point + from.direction * before, from.direction, to.direction, radius, steps))
    add(p);
  if (line.size() > 1 && (to.point - line.back()).norm() <= 0.02) line.pop_back();
  line.push_back(to.point);
  return line;
}

/// Removes points near the ends where an offset around a bend folds the lane back.
void drop_folds(Polyline& line) {
  constexpr double min_length_m = 1;
  while (line.size() > 2 && (line[1] - line[0]).dot(line[2] - line[1]) <= 0) line.erase(line.begin() + 1);
  while (line.size() > 2 && (line[1] - line[0]).norm() < min_length_m) line.erase(line.begin() + 1);
  const auto last = [&](std::size_t i) { return line[line.size() - 1 - i]; };
  while (line.size() > 2 && (last(0) - last(1)).dot(last(1) - last(2)) <= 0) line.erase(line.end() - 2);
  while (line.size() > 2 && (last(0) - last(1)).norm() < min_length_m) line.erase(line.end() - 2);
}

class JunctionLinks {
 public:
  JunctionLinks(const StreetNetwork& network, int junction, const std::vector<SegmentLanes>& by_segment,
                std::vector<DrivingLane>& lanes)
      : network(network), junction(junction), by_segment(by_segment), lanes(lanes) {}

  void link() {
    std::vector<Side> arms;
    for (const Side& arm : network.junctions[junction].arms)
      if (network.is_road(arm)) arms.push_back(arm);
    for (const Side& in : arms) {
      bool has_right = false, has_left = false;
      for (const Side& out : arms) {
        if (in == out || arriving(in).empty() || leaving(out).empty()) continue;
        const double angle = change(arriving(in)[0], leaving(out)[0]);
        has_right |= angle <= -straight_rad;
        has_left |= angle >= straight_rad;
      }
      for (const Side& out : arms)
        if (!(in == out)) link_arms(arriving(in), leaving(out), has_right, has_left);
    }
    for (const Side& arm : arms) {  // every lane gets a way out and a way in
      for (std::size_t i = 0; i < arriving(arm).size(); ++i)
        if (lanes[arriving(arm)[i]].next.empty()) link_to_nearest(arms, arm, i, true);
      for (std::size_t i = 0; i < leaving(arm).size(); ++i)
        if (!is_entered(leaving(arm)[i])) link_to_nearest(arms, arm, i, false);
    }
  }

 private:
  const std::vector<int>& arriving(const Side& arm) const { return by_segment[arm.segment][!arm.reversed]; }
  const std::vector<int>& leaving(const Side& arm) const { return by_segment[arm.segment][arm.reversed]; }

  double change(int in, int out) const {
    return heading_change(end_of(lanes[in].points), start_of(lanes[out].points));
  }

  bool is_entered(int lane) const {
    return std::any_of(lanes.begin(), lanes.end(), [&](const DrivingLane& l) {
      return l.junction == junction && l.next.front() == lane;
    });
  }

  void link_arms(const std::vector<int>& in, const std::vector<int>& out, bool has_right, bool has_left) {
    if (in.empty() || out.empty()) return;
    const double angle = change(in[0], out[0]);
    if (std::abs(angle) < straight_rad) {
      for (std::size_t i = 0; i < std::min(in.size(), out.size()); ++i) add(in[i], out[i]);
      // Lanes without a turn may change lanes, or their traffic could never leave this street.
      for (std::size_t i = 0; i < in.size(); ++i) {
        const bool turns = (i == 0 && has_right) || (i + 1 == in.size() && has_left);
        if (turns) continue;
        if (i > 0 && i - 1 < out.size()) add(in[i], out[i - 1]);
        if (i == 0 && out.size() > 1) add(in[i], out[1]);
      }
    } else {
      for (const int lane : out) add(angle < 0 ? in.front() : in.back(), lane);
    }
  }

  /// Links lane `i` of an arm with the arm straightest ahead: onwards from an arriving lane, or into a
  /// leaving lane.
  void link_to_nearest(const std::vector<Side>& arms, const Side& arm, std::size_t i, bool onwards) {
    double best = 4;
    std::pair<int, int> chosen{-1, -1};
    for (const Side& other : arms) {
      const std::vector<int>& theirs = onwards ? leaving(other) : arriving(other);
      if (other == arm || theirs.empty()) continue;
      const int mine = onwards ? arriving(arm)[i] : leaving(arm)[i],
                its = theirs[std::min(i, theirs.size() - 1)];
      const std::pair<int, int> link = onwards ? std::pair{mine, its} : std::pair{its, mine};
      if (const double angle = std::abs(change(link.first, link.second)); angle < best) {
        best = angle;
        chosen = link;
      }
    }
    if (chosen.first >= 0) add(chosen.first, chosen.second);
  }

  void add(int in, int out) {
    const LaneEnd from = end_of(lanes[in].points), to = start_of(lanes[out].points);
    // At most concentric with the rounded kerb, because a wider arc would cut the corner.
    double kerb = 8;
    for (const double radius : network.junctions[junction].radii)
      if (radius > 0) kerb = std::min(kerb, radius);
    const bool right = heading_change(from, to) < 0;
    const double room = right ? std::min(lanes[in].right_kerb_m, lanes[out].right_kerb_m)
                              : std::min(lanes[in].left_kerb_m, lanes[out].left_kerb_m);
    DrivingLane lane;
    lane.street = lanes[in].street;
    lane.width_m = std::min(lanes[in].width_m, lanes[out].width_m);
    const Junction& crossed = network.junctions[junction];
    const std::vector<int>& beside = by_segment[lanes[in].segment][lanes[in].backward];
    const auto from_kerb = static_cast<int>(std::find(beside.begin(), beside.end(), in) - beside.begin());
    lane.points = crossed.roundabout
                      ? roundabout_way(*crossed.roundabout, crossed.position, {from.point, from.direction},
                                       {to.point, to.direction}, from_kerb)
                      : turn(from, to, kerb + room);
    lane.next = {out};
    lane.junction = junction;
    lanes[in].next.push_back(static_cast<int>(lanes.size()));
    lanes.push_back(std::move(lane));
  }

  const StreetNetwork& network;
  int junction;
  const std::vector<SegmentLanes>& by_segment;
  std::vector<DrivingLane>& lanes;
};

}  // namespace

std::vector<DrivingLane> driving_lanes(const StreetNetwork& network) {
  std::vector<DrivingLane> lanes;
  std::vector<SegmentLanes> by_segment(network.segments.size());
  for (std::size_t s = 0; s < network.segments.size(); ++s) {
    const Segment& segment = network.segments[s];
    if (segment.street < 0) continue;
    const StreetProfile& profile = network.streets[segment.street].profile;
    const Polyline centre = cut(segment.centre, segment.cut_from, length(segment.centre) - segment.cut_to);
    const auto add = [&](double left_m, bool backward) {
      DrivingLane lane;
      lane.street = segment.street;
      lane.segment = static_cast<int>(s);
      lane.backward = backward;
      lane.width_m = profile.lane_width_m;
      lane.points = offset(centre, left_m);
      drop_folds(lane.points);
      if (backward) std::reverse(lane.points.begin(), lane.points.end());
      lane.left_kerb_m = profile.half_width() + (backward ? left_m : -left_m);
      lane.right_kerb_m = 2 * profile.half_width() - lane.left_kerb_m;
      by_segment[s][backward].push_back(static_cast<int>(lanes.size()));
      lanes.push_back(std::move(lane));
    };
    for (int i = 0; i < profile.lanes_forward; ++i) add(profile.forward_lane_offset(i), false);
    for (int i = 0; i < profile.lanes_backward; ++i) add(profile.backward_lane_offset(i), true);
  }
  for (int j = 0; j < static_cast<int>(network.junctions.size()); ++j)
    JunctionLinks(network, j, by_segment, lanes).link();
  return lanes;
}

}  // namespace cps::city
