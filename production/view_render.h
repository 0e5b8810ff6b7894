#pragma once

#include "production/lit_scene.h"
#include "renderer/render.h"
#include "sampler/plan/plan.h"

namespace cps {

/// A view's undistorted, linear, oversampled render: two images, each with half of the samples.
struct RenderedHalves {
  OIIO::ImageBuf first, second;
  double cpu_s = 0;        ///< CPU seconds of both
  double cells_cpu_s = 0;  ///< those among them that computed cells of the light cache
};

/// The view's rig camera in the world, with `pinhole` as its intrinsics.
Camera camera_of(const PlannedView& view, const Pinhole& pinhole);

/// Moves the car to the view's place and renders with `pinhole`, which is the view's master camera or a
/// smaller one, by the recipe's samples and path length, with the scene's cache. `progress` is called after
/// each tile; what it throws ends the render.
RenderedHalves render_halves(const Recipe& recipe, const PlannedView& view, const Pinhole& pinhole,
                             LitScene& lit, const TileProgress& progress = {});

}  // namespace cps
