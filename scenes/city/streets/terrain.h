#pragma once

#include <vector>

#include "scenes/city/city_options.h"
#include "scenes/city/geometry/mesh.h"

/// The terrain. The city is built on a level plan with heights above the carriageway; before writing, its
/// meshes are draped over the terrain or stood on it.
namespace cps::city {

/// A smooth height field, the sum of a few long sine waves, so that slope and curvature are bounded.
struct Terrain {
  struct Wave {
    Vec2 per_metre;  ///< wave vector, radians per metre east and north
    double amplitude_m, phase_rad;
  };
  std::vector<Wave> waves;  ///< empty: level

  double height_m(const Vec2& plan) const;
  /// Rise per metre towards east and north.
  Vec2 slope(const Vec2& plan) const;
  /// An upper bound of the slope: the sum of the waves' steepest slopes.
  double steepest() const;
};

/// The steepest slope of a city of that style. Factories and towers stand on flatter ground.
double slope_limit(CityStyle style);

/// The terrain of a city; level for a quarter of the seeds.
Terrain draw_terrain(const CityOptions& options);

/// The longest edges of draped ground. At the largest curvature (6 % slope, 350 m wavelength) a face of that
/// size deviates from the terrain by 1.7 mm on roads, less than the patches' height above the asphalt, and by
/// 8 mm on blocks, less than the pads' rise.
inline constexpr double max_road_edge_m = 3.5, max_block_edge_m = 7.5;

/// Raises every vertex by the terrain's height there.
void lift_onto(Mesh& mesh, const Terrain& terrain);

/// Refines the mesh, then raises it onto the terrain: for ground seen from near. Edges shared by faces of two
/// meshes stay shared.
void drape(Mesh& mesh, const Terrain& terrain, double longest_edge_m = max_road_edge_m);

/// The line on the terrain, in glTF's frame, with no piece longer than `max_road_edge_m`.
std::vector<Vec3> on_terrain(const Polyline& line, const Terrain& terrain);

}  // namespace cps::city
