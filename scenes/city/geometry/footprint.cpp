#include "scenes/city/geometry/footprint.h"

#include <algorithm>
#include <cmath>

namespace cps::city {

Polyline Footprint::line_at(double depth) const {
  Polyline line(front.size());
  for (std::size_t i = 0; i < front.size(); ++i) line[i] = at(i, depth);
  return line;
}

Polygon Footprint::polygon() const {
  Polygon ring = front;
  const Polyline back = line_at(depth_m);
  ring.insert(ring.end(), back.rbegin(), back.rend());
  return ring;
}

Footprint Footprint::lengthened(double at_start_m, double at_end_m) const {
  Footprint longer = *this;
  const std::size_t n = front.size();
  longer.front[0] -= (front[1] - front[0]).normalized() * at_start_m;
  longer.front[n - 1] += (front[n - 1] - front[n - 2]).normalized() * at_end_m;
  return longer;
}

Footprint make_footprint(const Polyline& front, double depth_m) {
  Footprint footprint{front, {}, depth_m};
  const Polyline inner = offset(front, 1.0);
  for (std::size_t i = 0; i < front.size(); ++i) footprint.inward.push_back(inner[i] - front[i]);
  return footprint;
}

Footprint turned(const Footprint& footprint) {
  return make_footprint({footprint.front[1], footprint.at(1, footprint.depth_m)},
                        (footprint.front[1] - footprint.front[0]).norm());
}

void add_loft(Surface& surface, const Footprint& footprint, const std::vector<ProfilePoint>& profile,
              double tile_m) {
  double v = 0;
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const ProfilePoint &a = profile[k - 1], &b = profile[k];
    const double step = std::hypot(b.depth - a.depth, b.height - a.height) / tile_m;
    const double v_next =
        b.height >= a.height ? v - step : v + step;  // the image's top is at the higher edge
    double u = 0;
    for (std::size_t i = 1; i < footprint.front.size(); ++i) {
      const double u_next = u + (footprint.front[i] - footprint.front[i - 1]).norm() / tile_m;
      add_quad(surface, {lift(footprint.at(i - 1, a.depth), a.height), {u, v}},
               {lift(footprint.at(i, a.depth), a.height), {u_next, v}},
               {lift(footprint.at(i, b.depth), b.height), {u_next, v_next}},
               {lift(footprint.at(i - 1, b.depth), b.height), {u, v_next}});
      u = u_next;
    }
    v = v_next;
  }
}

void add_loft_ends(Surface& surface, const Footprint& footprint, const std::vector<ProfilePoint>& profile,
                   double tile_m, bool start, bool end) {
  for (const bool at_end : {false, true}) {
    if (at_end ? !end : !start) continue;
    std::vector<Vertex> face;
    for (const ProfilePoint& p : profile)
      face.push_back({lift(footprint.at(at_end ? footprint.front.size() - 1 : 0, p.depth), p.height),
                      {(at_end ? p.depth : -p.depth) / tile_m, -p.height / tile_m}});
    if (at_end) std::reverse(face.begin(), face.end());
    add_polygon(surface, face);
  }
}

}  // namespace cps::city
