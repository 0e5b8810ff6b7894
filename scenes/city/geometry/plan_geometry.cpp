#include "scenes/city/geometry/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "numbers/segment_distance.h"

namespace cps::city {

Vec2 miter(const Vec2& direction_in, const Vec2& direction_out) {
  const Vec2 a = left_of(direction_in), b = left_of(direction_out);
  return (a + b) / (1.0 + a.dot(b));
}

Polyline offset(const Polyline& line, double left_m) {
  Polyline moved(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 in = (line[std::max<std::size_t>(i, 1)] - line[std::max<std::size_t>(i, 1) - 1]).normalized();
    const std::size_t last = std::min(i, line.size() - 2);
    const Vec2 out = (line[last + 1] - line[last]).normalized();
    moved[i] = line[i] + miter(in, out) * left_m;
  }
  return moved;
}

std::vector<Vec2> inward_miters(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  std::vector<Vec2> inward(n);
  for (std::size_t i = 0; i < n; ++i)
    inward[i] = miter((polygon[i] - polygon[(i + n - 1) % n]).normalized(),
                      (polygon[(i + 1) % n] - polygon[i]).normalized());
  return inward;
}

double length(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

Station station_at(const Polyline& line, double s) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 step = line[i] - line[i - 1];
    const double l = step.norm();
    if (s <= l || i + 1 == line.size()) return {line[i - 1] + step * std::clamp(s / l, 0.0, 1.0), step / l};
    s -= l;
  }
  return {line.front(), Vec2(1, 0)};
}

Polyline cut(const Polyline& line, double from_m, double to_m) {
  Polyline piece{station_at(line, from_m).point};
  double s = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    s += (line[i] - line[i - 1]).norm();
    if (s > from_m + 1e-6 && s < to_m - 1e-6) piece.push_back(line[i]);
  }
  piece.push_back(station_at(line, to_m).point);
  return piece;
}

Polyline subdivided(const Polyline& line, double step_m) {
  Polyline fine{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 step = line[i] - line[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(step.norm() / step_m)));
    for (int k = 1; k < pieces; ++k) fine.push_back(line[i - 1] + step * (static_cast<double>(k) / pieces));
    fine.push_back(line[i]);
  }
  return fine;
}

double signed_area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

bool contains(const Polygon& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

namespace {

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double c1 = cross(b - a, c - a), c2 = cross(b - a, d - a), c3 = cross(d - c, a - c),
               c4 = cross(d - c, b - c);
  return c1 * c2 < 0 && c3 * c4 < 0;
}

Vec2 centroid(const Polygon& polygon) {
  return std::accumulate(polygon.begin(), polygon.end(), Vec2(0, 0)) / static_cast<double>(polygon.size());
}

}  // namespace

bool overlap(const Polygon& a, const Polygon& b, double slack_m) {
  Polygon shrunk = a;
  const std::vector<Vec2> inward = inward_miters(a);
  for (std::size_t i = 0; i < a.size(); ++i) shrunk[i] += inward[i] * slack_m;
  for (std::size_t i = 0; i < shrunk.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (segments_cross(shrunk[i], shrunk[(i + 1) % shrunk.size()], b[j], b[(j + 1) % b.size()]))
        return true;
  for (const Vec2& p : shrunk)
    if (contains(b, p)) return true;
  for (const Vec2& p : b)
    if (contains(shrunk, p)) return true;
  return contains(b, centroid(shrunk)) && contains(shrunk, centroid(shrunk));
}

double distance_to_polygon(const Polygon& polygon, const Vec2& point) {
  if (contains(polygon, point)) return 0;
  double best = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    best = std::min(best, distance_to_segment<double>(polygon[i], polygon[(i + 1) % polygon.size()], point));
  return best;
}

double distance_to_line(const Polyline& line, const Vec2& point) {
  double best = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < line.size(); ++i)
    best = std::min(best, distance_to_segment<double>(line[i - 1], line[i], point));
  return best;
}

Polyline fillet(const Vec2& corner, const Vec2& direction_in, const Vec2& direction_out, double radius_m,
                int steps) {
  const double turn = std::atan2(cross(direction_in, direction_out), direction_in.dot(direction_out));
  const double side = turn >= 0 ? 1.0 : -1.0;
  const Vec2 start = corner - direction_in * (radius_m * std::tan(std::abs(turn) / 2));
  const Vec2 centre = start + left_of(direction_in) * (side * radius_m);
  Polyline arc(steps + 1);
  for (int i = 0; i <= steps; ++i) {
    const double angle = turn * i / steps;
    const Vec2 spoke = start - centre;
    arc[i] = centre + Vec2(std::cos(angle) * spoke.x() - std::sin(angle) * spoke.y(),
                           std::sin(angle) * spoke.x() + std::cos(angle) * spoke.y());
  }
  return arc;
}

namespace {

using Triangle = std::array<int, 3>;

/// Whether d lies inside the circle through a, b and c (given anticlockwise).
bool in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 u = a - d, v = b - d, w = c - d;
  return u.squaredNorm() * cross(v, w) + v.squaredNorm() * cross(w, u) + w.squaredNorm() * cross(u, v) > 1e-6;
}

/// Flips diagonals until the triangulation is Delaunay (Lawson 1977): ear clipping alone leaves long slivers.
void flip_diagonals(const Polygon& p, std::vector<Triangle>& triangles) {
  std::map<std::pair<int, int>, int> owner;  // of a directed edge: its triangle
  const auto own = [&](int t) {
    for (int k = 0; k < 3; ++k) owner[{triangles[t][k], triangles[t][(k + 1) % 3]}] = t;
  };
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) own(t);
  const auto is_front = [&](int a, int b, int c) { return cross(p[b] - p[a], p[c] - p[a]) > 1e-6; };
  const auto flip_one = [&](int t) {
    for (int k = 0; k < 3; ++k) {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3], c = triangles[t][(k + 2) % 3];
      const auto other = owner.find({b, a});
      if (other == owner.end()) continue;
      const int u = other->second, d = triangles[u][0] + triangles[u][1] + triangles[u][2] - a - b;
      if (!in_circle(p[a], p[b], p[c], p[d]) || !is_front(c, a, d) || !is_front(d, b, c)) continue;
      owner.erase({a, b});
      owner.erase({b, a});
      triangles[t] = {c, a, d};
      triangles[u] = {d, b, c};
      own(t);
      own(u);
      return true;
    }
    return false;
  };
  const std::size_t max_flips = triangles.size() * triangles.size();  // no planar set needs more flips
  std::size_t flips = 0;
  for (std::size_t quiet = 0, t = 0; quiet < triangles.size() && flips < max_flips;
       t = (t + 1) % triangles.size()) {
    const bool flipped = flip_one(static_cast<int>(t));
    flips += flipped;
    quiet = flipped ? 0 : quiet + 1;
  }
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const Polygon& polygon) {
  std::vector<int> ring;  // without repeated points, whose neighbours could not be ears
  for (int i = 0; i < static_cast<int>(polygon.size()); ++i)
    if (ring.empty() || (polygon[i] - polygon[ring.back()]).norm() > 1e-6) ring.push_back(i);
  while (ring.size() > 1 && (polygon[ring.back()] - polygon[ring.front()]).norm() <= 1e-6) ring.pop_back();
  std::vector<std::array<int, 3>> triangles;
  const auto is_ear = [&](std::size_t i) {
    const int a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i], c = ring[(i + 1) % ring.size()];
    if (cross(polygon[b] - polygon[a], polygon[c] - polygon[b]) <= 1e-9) return false;
    return std::none_of(ring.begin(), ring.end(), [&](int p) {
      return p != a && p != b && p != c && cross(polygon[b] - polygon[a], polygon[p] - polygon[a]) >= 0 &&
             cross(polygon[c] - polygon[b], polygon[p] - polygon[b]) >= 0 &&
             cross(polygon[a] - polygon[c], polygon[p] - polygon[c]) >= 0;
    });
  };
  while (ring.size() > 2) {
    std::size_t ear = 0;
    while (ear < ring.size() && !is_ear(ear)) ++ear;
    if (ear == ring.size()) {  // only collinear points are left
      ring.erase(ring.begin());
      continue;
    }
    triangles.push_back(
        {ring[(ear + ring.size() - 1) % ring.size()], ring[ear], ring[(ear + 1) % ring.size()]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  flip_diagonals(polygon, triangles);
  return triangles;
}

Polyline arc(const Vec2& centre, const Vec2& start, double sweep_rad, int steps) {
  Polyline points;
  for (int i = 0; i <= steps; ++i) {
    const double a = sweep_rad * i / steps;
    const Vec2 spoke = start - centre;
    points.push_back(centre + Vec2(std::cos(a) * spoke.x() - std::sin(a) * spoke.y(),
                                   std::sin(a) * spoke.x() + std::cos(a) * spoke.y()));
  }
  return points;
}

}  // namespace cps::city
