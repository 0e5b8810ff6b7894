#pragma once

#include "renderer/render.h"
#include "sampler/plan/plan.h"

namespace cps {

/// A view's undistorted, linear, oversampled render, as two halves of its samples.
struct RenderedHalves {
  OIIO::ImageBuf first, second;
  double cpu_s = 0;  ///< that both took
};

/// Where the view's rig camera stands, seeing what `pinhole` does.
Camera camera_of(const PlannedView& view, const Pinhole& pinhole);

/// Puts the car where the view has it, and renders what `pinhole` sees, the view's master or one like it.
/// `progress` may throw.
RenderedHalves render_halves(const Plan& plan, const PlannedView& view, const Pinhole& pinhole,
                             RenderScene& scene, const TileProgress& progress = {});

}  // namespace cps
