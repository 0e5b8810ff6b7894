#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scenes/city/geometry/plan_geometry.h"

/// Meshes under construction, in glTF's frame: y up, metres, anticlockwise front faces.
namespace cps::city {

using Vec3 = Eigen::Vector3d;
using MaterialId = int;

/// The point in glTF's frame at a plan position (x east, y north) and a height.
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

/// The gray vertex colour of a lightness, 0 to 1.
std::array<std::uint8_t, 4> gray_color(double light);

struct Mesh {
  std::string name;
  std::map<MaterialId, Surface> surfaces;

  /// True without surfaces; such a mesh is not written.
  bool empty() const { return surfaces.empty(); }
  std::size_t triangle_count() const;
};

/// A corner with its texture coordinates, in tiles.
struct Vertex {
  Vec3 position;
  Vec2 uv = {0, 0};
};

/// Adds a flat-shaded triangle or convex planar polygon, given anticlockwise. Skips polygons without area.
void add_polygon(Surface& surface, const std::vector<Vertex>& corners);
inline void add_quad(Surface& surface, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  add_polygon(surface, {a, b, c, d});
}

/// Adds a box over a rectangle of the plan, with half sizes along and across the unit vector `along`, from
/// height `bottom` to `top`. Texture coordinates are metres / `tile_m`. It has a bottom face only if
/// `with_bottom`.
void add_box(Surface& surface, const Vec2& centre, const Vec2& along, double half_length, double half_width,
             double bottom, double top, double tile_m = 1, bool with_bottom = false);

/// Adds an axis-aligned box, bottom included, between two opposite corners (glTF's frame).
void add_block(Surface& surface, const Vec3& low, const Vec3& high, double tile_m = 1);

/// Adds a horizontal face over any simple polygon of the plan; texture coordinates are world metres /
/// `tile_m`.
void add_floor(Surface& surface, const Polygon& polygon, double height, double tile_m);

/// Adds a smooth-shaded tapered tube, closed at the far end if `capped`.
void add_tube(Surface& surface, const Vec3& from, const Vec3& to, double radius_from, double radius_to,
              int sides, bool capped = false, double tile_m = 1);

}  // namespace cps::city
