#pragma once

#include <functional>

#include "renderer/cache/cell.h"

namespace cps {

struct Hit;
struct Path;
struct RenderScene;
struct SunAndSkyRays;

/// Light that arrives at a cell's surfaces from everywhere but the sun and the lamps that light samples draw.
struct CellLight {
  /// Mean radiance from above the surfaces, weighted by the cosine: a white Lambert surface's.
  Color radiance = Color::Zero();
  /// Mean direction of its luminance, weighted so that a surface whose normal n differs a little from the
  /// cell's m gets radiance · n·towards / m·towards. 0 without any light.
  Vec3 towards = Vec3::Zero();
  bool is_known = false;  ///< false: hardly any of the cell's surface was found
  bool is_near = false;   ///< other surfaces stand so close that the light may change within the cell
};

/// Deals with the surface that a path hits, see trace_paths_with().
using ShadeVertex = std::function<SunAndSkyRays(Path&, const Hit&)>;

/// A pure function of scene, light and cell, if `shade` is one of path and hit. Draws points on the cell's
/// surfaces by rays through the cell and traces paths from them, which pass what rides with the car. Adds the
/// traced rays to `rays`.
CellLight compute_cell_light(const RenderScene& scene, const Cell& cell, const ShadeVertex& shade,
                             std::uint32_t& rays);

}  // namespace cps
