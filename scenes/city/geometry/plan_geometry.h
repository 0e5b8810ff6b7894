#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

/// Geometry of the city's plan, seen from above: x east, y north, metres. Polygons run anticlockwise.
namespace cps::city {

using Vec2 = Eigen::Vector2d;
using Polyline = std::vector<Vec2>;
using Polygon = std::vector<Vec2>;

inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}
inline Vec2 left_of(const Vec2& direction) {
  return {-direction.y(), direction.x()};
}

/// The miter of a corner: moving the corner by `miter * d` moves both lines to their left by d.
Vec2 miter(const Vec2& direction_in, const Vec2& direction_out);

/// The polyline moved to its left by `left_m` (negative: right), with mitred joints and the same number of
/// points.
Polyline offset(const Polyline& line, double left_m);

/// The miters of a closed polygon's corners, pointing inwards.
std::vector<Vec2> inward_miters(const Polygon& polygon);

double length(const Polyline& line);

struct Station {
  Vec2 point;
  Vec2 direction;  ///< unit
};

/// The point `s` metres along the line, clamped to the line, and the direction there.
Station station_at(const Polyline& line, double s);

/// The piece of the line between two stations, with the vertices between them.
Polyline cut(const Polyline& line, double from_m, double to_m);

/// The same line with points added so that no piece is longer than `step_m`.
Polyline subdivided(const Polyline& line, double step_m);

/// Positive for anticlockwise polygons.
double signed_area(const Polygon& polygon);

bool contains(const Polygon& polygon, const Vec2& point);

/// Whether two polygons overlap by more than `slack_m` at their borders.
bool overlap(const Polygon& a, const Polygon& b, double slack_m = 0.02);

double distance_to_polygon(const Polygon& polygon, const Vec2& point);
double distance_to_line(const Polyline& line, const Vec2& point);

/// The arc that rounds a corner: `steps` + 1 points from the incoming line to the outgoing one. Radius 0
/// repeats the corner, so that all offsets of an outline have the same number of points.
Polyline fillet(const Vec2& corner, const Vec2& direction_in, const Vec2& direction_out, double radius_m,
                int steps);

/// Triangulates a simple anticlockwise polygon by ear clipping (Meisters 1975), then flips diagonals to avoid
/// slivers.
std::vector<std::array<int, 3>> triangulate(const Polygon& polygon);

/// The arc from `start` around `centre` by `sweep_rad` (positive: anticlockwise): `steps` + 1 points.
Polyline arc(const Vec2& centre, const Vec2& start, double sweep_rad, int steps);

}  // namespace cps::city
