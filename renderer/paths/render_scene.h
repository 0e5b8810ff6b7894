#pragma once

#include "renderer/geometry/geometry.h"
#include "renderer/geometry/trace.h"
#include "renderer/lights/lamps.h"
#include "renderer/lights/sky_models.h"
#include "renderer/materials/material.h"

namespace cps {

/// What a ray may meet, in the order of who points at whom.
struct RenderScene {
  RenderScene(const Scene& scene, SkyAndSun light);

  Materials materials;
  PlacedGeometry placed;
  std::vector<Eigen::Affine3f> vehicle_from_mesh;  ///< of the placements that ride, in their order
  Bvh bvh;
  Lamps lamps;
  Sky sky;
  Sun sun;
};

}  // namespace cps
