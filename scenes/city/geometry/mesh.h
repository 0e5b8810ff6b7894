#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scenes/city/geometry/plan_geometry.h"

/// Triangles being built, in glTF's frame: y up, metres, anticlockwise front faces.
namespace cps::city {

using Vec3 = Eigen::Vector3d;
using MaterialId = int;

/// From the plan (x east, y north) and a height to glTF's frame.
inline Vec3 lift(const Vec2& plan, double height) {
  return {plan.x(), height, -plan.y()};
}

/// Triangles of one material. `colors` (linear, multiply the base colour) and `uvs` are empty or one per
/// vertex.
struct Surface {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<Eigen::Vector2f> uvs;
  std::vector<std::array<std::uint8_t, 4>> colors;
  std::vector<std::uint32_t> indices;
};

/// A vertex colour from a lightness of 0 … 1.
std::array<std::uint8_t, 4> gray_color(double light);

struct Mesh {
  std::string name;
  std::map<MaterialId, Surface> surfaces;

  /// A mesh without surfaces is not written.
  bool empty() const { return surfaces.empty(); }
  std::size_t triangle_count() const;
};

/// A corner given with its texture coordinates, in tiles.
struct Vertex {
  Vec3 position;
  Vec2 uv = {0, 0};
};

/// The triangle or convex planar polygon (anticlockwise from its front), flat-shaded. Slivers without area
/// are left out.
void add_polygon(Surface& surface, const std::vector<Vertex>& corners);
inline void add_quad(Surface& surface, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  add_polygon(surface, {a, b, c, d});
}

/// A box over a rectangle of the plan: `centre`, unit `along`, half sizes along and across it, from `bottom`
/// to `top`. Texture coordinates are metres / `tile_m`. The bottom face is left out unless `with_bottom`.
void add_box(Surface& surface, const Vec2& centre, const Vec2& along, double half_length, double half_width,
             double bottom, double top, double tile_m = 1, bool with_bottom = false);

/// The same between its low and its high corner (glTF's frame), along the axes and with a bottom.
void add_block(Surface& surface, const Vec3& low, const Vec3& high, double tile_m = 1);

/// A horizontal face over a plan polygon (any simple one), texture coordinates in world metres / `tile_m`.
void add_floor(Surface& surface, const Polygon& polygon, double height, double tile_m);

/// A tapered tube from `from` to `to`, smooth-shaded, closed at the far end if `capped`.
void add_tube(Surface& surface, const Vec3& from, const Vec3& to, double radius_from, double radius_to,
              int sides, bool capped = false, double tile_m = 1);

}  // namespace cps::city
