#include "scenes/city/geometry/strip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scenes/city/noise.h"

namespace cps::city {

double weathering(Stream stream, const Vec2& point) {
  constexpr double tile_m = 512;
  return 0.82 + 0.16 * fractal_noise(stream, point.x() / tile_m, point.y() / tile_m, 64, 4);
}

void add_strip(Surface& surface, const Polyline& left, const Polyline& right, const StripStyle& style) {
  double along = 0;
  for (std::size_t i = 1; i < left.size(); ++i) {
    const double piece = (right[i] - right[i - 1]).norm(), wide = (left[i] - left[i - 1]).norm();
    if (std::max(piece, wide) < 1e-6) continue;
    const Vec3 slope = (lift(left[i - 1], style.left_height) - lift(right[i - 1], style.right_height));
    const Vec3 normal = lift(right[i] - right[i - 1] + left[i] - left[i - 1], 0).cross(slope).normalized();
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    for (const std::size_t k : {i - 1, i}) {
      const double u = (along + (k == i ? piece : 0.0)) / style.tile_m;
      const double across =
          std::hypot((left[k] - right[k]).norm(), style.left_height - style.right_height) / style.tile_m;
      for (const auto& [p, height, v] :
           {std::tuple{right[k], style.right_height, 0.0}, {left[k], style.left_height, -across}}) {
        surface.positions.push_back(lift(p, height).cast<float>());
        surface.normals.push_back(normal.cast<float>());
        surface.uvs.emplace_back(static_cast<float>(u), static_cast<float>(v));
      }
    }
    // In order: right, left, next right, next left.
    if (piece > 1e-6) surface.indices.insert(surface.indices.end(), {first, first + 2, first + 3});
    if (wide > 1e-6) surface.indices.insert(surface.indices.end(), {first, first + 3, first + 1});
    along += piece;
  }
}

void add_stripe(Surface& surface, const Polyline& centre, double width_m, double height, double tile_m) {
  add_strip(surface, offset(centre, width_m / 2), offset(centre, -width_m / 2), {height, height, tile_m});
}

}  // namespace cps::city
