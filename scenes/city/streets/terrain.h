#pragma once

#include <vector>

#include "scenes/city/city_options.h"
#include "scenes/city/geometry/mesh.h"

/// The lie of the land. Everything is built over a level plan, heights counted from the carriageway; what is
/// written to the file is then draped over the terrain or stood on it.
namespace cps::city {

/// A smooth height field: a few long waves, so that slope and curvature are bounded.
struct Terrain {
  struct Wave {
    Vec2 per_metre;  ///< radians per metre, east and north
    double amplitude_m, phase_rad;
  };
  std::vector<Wave> waves;  ///< none: level

  double height_m(const Vec2& plan) const;
  /// Rise per metre towards east and north.
  Vec2 slope(const Vec2& plan) const;
  /// No slope anywhere is steeper: the sum of the waves' own.
  double steepest() const;
};

/// The steepest slope a city of that style may have. Works and towers stand on more level ground.
double slope_limit(CityStyle style);

/// A quarter of the seeds are level.
Terrain draw_terrain(const CityOptions& options);

/// No edge of draped ground is longer. At the sharpest bend a wave can have (6 % over 350 m) a face of that
/// size leaves the terrain by 1.7 mm on roads, less than the patches lie above the asphalt, and by 8 mm on
/// blocks, less than the pads' rise.
inline constexpr double longest_road_edge_m = 3.5, longest_block_edge_m = 7.5;

/// Lifts every vertex by the terrain's height there.
void lift_onto(Mesh& mesh, const Terrain& terrain);

/// The same for ground that is seen from near: divides the mesh finely first. Edges that faces of two meshes
/// share stay shared.
void drape(Mesh& mesh, const Terrain& terrain, double longest_edge_m = longest_road_edge_m);

/// The line with the terrain's heights, in glTF's frame, no piece longer than `longest_road_edge_m`.
std::vector<Vec3> on_terrain(const Polyline& line, const Terrain& terrain);

}  // namespace cps::city
