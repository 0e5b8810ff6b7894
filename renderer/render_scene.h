#pragma once

#include "renderer/geometry.h"
#include "renderer/lamps.h"
#include "renderer/material.h"
#include "renderer/render.h"
#include "renderer/sky_models.h"
#include "renderer/trace.h"

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
