#pragma once

#include "renderer/geometry/geometry.h"
#include "renderer/geometry/trace.h"
#include "renderer/lights/lamps.h"
#include "renderer/lights/sky_models.h"
#include "renderer/materials/material.h"

namespace cps {

/// A scene ready for rendering under one light, see build_render_scene(). Each member may point into those
/// before it.
struct RenderScene {
  RenderScene(const Scene& scene, SkyAndSun light);

  Materials materials;
  PlacedGeometry placed;
  std::vector<Eigen::Affine3f>
      vehicle_from_mesh;           ///< of the placements that ride with the car, in their order
  Eigen::AlignedBox3f car_bounds;  ///< of what rides with the car, where it is now; empty: nothing does
  Bvh bvh;
  Lamps lamps;
  Sky sky;
  Sun sun;
};

}  // namespace cps
