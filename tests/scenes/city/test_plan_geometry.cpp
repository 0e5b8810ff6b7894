#include <catch2/catch.hpp>
#include <cmath>

#include "scenes/city/geometry/plan_geometry.h"

using namespace cps::city;

TEST_CASE("an offset line has the given distance from every piece of the original") {
  const Polyline line{{0, 0}, {20, 0}, {35, 9}, {60, 4}};
  for (const double d : {3.0, -2.5}) {
    const Polyline moved = offset(line, d);
    REQUIRE(moved.size() == line.size());
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec2 direction = (line[i] - line[i - 1]).normalized();
      for (const Vec2& p : {moved[i - 1], moved[i]})
        CHECK(cross(direction, p - line[i - 1]) == Approx(d).margin(1e-9));
    }
  }
}

TEST_CASE("a fillet is an arc of its radius that touches both lines") {
  const Vec2 corner(4, 7), in(1, 0), out = Vec2(-0.3, 1).normalized();
  const Polyline arc = fillet(corner, in, out, 5, 16);
  CHECK(std::abs(cross(in, arc.front() - corner)) < 1e-12);
  CHECK(std::abs(cross(out, arc.back() - corner)) < 1e-9);
  const Vec2 centre = arc.front() + left_of(in) * 5;
  for (const Vec2& p : arc) CHECK((p - centre).norm() == Approx(5));
}

TEST_CASE("a triangulation has the polygon's area and no inverted triangle") {
  const Polygon l_shape{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}};
  double area = 0;
  for (const auto& [a, b, c] : triangulate(l_shape)) {
    const double part = cross(l_shape[b] - l_shape[a], l_shape[c] - l_shape[a]) / 2;
    CHECK(part > 0);
    area += part;
  }
  CHECK(area == Approx(signed_area(l_shape)));
  CHECK(signed_area(l_shape) == Approx(18));
}

TEST_CASE("polygons that share ground overlap, polygons that share an edge do not") {
  const Polygon a{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const auto moved = [&](double x, double y) {
    Polygon b = a;
    for (Vec2& p : b) p += Vec2(x, y);
    return b;
  };
  CHECK(overlap(a, moved(3.5, 0)));
  CHECK(overlap(a, moved(3.5, 3.5)));
  CHECK(overlap(a, a));
  CHECK(overlap(a, Polygon{{1, 1}, {2, 1}, {2, 2}, {1, 2}}));
  CHECK(overlap(a, Polygon{{-1, 1}, {5, 1}, {5, 2}, {-1, 2}}));
  CHECK_FALSE(overlap(a, moved(4, 0)));
  CHECK_FALSE(overlap(a, moved(4.5, 4.5)));
}

TEST_CASE("a piece cut from a line has the requested length and the line's bends") {
  const Polyline line{{0, 0}, {10, 0}, {10, 10}};
  const Polyline piece = cut(line, 4, 13);
  CHECK(length(piece) == Approx(9));
  REQUIRE(piece.size() == 3);
  CHECK((piece[1] - Vec2(10, 0)).norm() < 1e-12);
  CHECK((station_at(line, 13).point - piece.back()).norm() < 1e-12);
  CHECK(length(subdivided(line, 0.7)) == Approx(20));
}

TEST_CASE("a polygon with repeated corners is triangulated completely") {
  // As in a block's border, where a corner of radius 0 is an arc of one repeated point. Ears next to such
  // corners used to be missed.
  Polygon polygon;
  for (const Vec2& corner : {Vec2(0, 0), Vec2(10, 0), Vec2(11, 8), Vec2(5, 4), Vec2(-1, 7)})
    for (int i = 0; i < 9; ++i) polygon.push_back(corner);
  polygon.push_back({-0.5, 3.5});
  double area = 0;
  for (const auto& [a, b, c] : triangulate(polygon))
    area += cross(polygon[b] - polygon[a], polygon[c] - polygon[a]) / 2;
  CHECK(area == Approx(signed_area(polygon)));
}

TEST_CASE("the triangulation of a convex polygon is Delaunay") {
  Polygon polygon;  // a block with rounded corners
  for (const auto& [corner, in, out] : {std::tuple{Vec2(0, 0), Vec2(0, -1), Vec2(1, 0)},
                                        {Vec2(60, 0), Vec2(1, 0), Vec2(0, 1)},
                                        {Vec2(60, 50), Vec2(0, 1), Vec2(-1, 0)},
                                        {Vec2(0, 50), Vec2(-1, 0), Vec2(0, -1)}})
    for (const Vec2& p : fillet(corner, in, out, 6, 8)) polygon.push_back(p);
  double area = 0;
  for (const auto& [i, j, k] : triangulate(polygon)) {
    const Vec2 a = polygon[i], b = polygon[j] - a, c = polygon[k] - a;
    area += cross(b, c) / 2;
    const Vec2 to_centre = Vec2(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                                b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) /
                           (2 * cross(b, c));
    for (const Vec2& p : polygon) CHECK((p - a - to_centre).norm() > to_centre.norm() - 1e-3);
  }
  CHECK(area == Approx(signed_area(polygon)));
}
