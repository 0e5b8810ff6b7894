#pragma once

#include <span>
#include <vector>

#include "distortion/models/model_camera.h"
#include "production/lit_scene.h"
#include "renderer/render.h"
#include "sampler/plan/plan.h"

namespace cps {

/// A view's linear light, as it is rendered for its images.
struct RenderedView {
  /// The undistorted, oversampled master: two images, each with half of the samples. Empty where images are
  /// traced.
  OIIO::ImageBuf first = {}, second = {};
  std::vector<OIIO::ImageBuf> traced = {};  ///< images, each through a lens of another family
  double cpu_s = 0;                         ///< CPU seconds of all
  double cells_cpu_s = 0;                   ///< those among them that computed cells of the light cache
};

/// The view's rig camera in the world, with `pinhole` as its intrinsics.
Camera camera_of(const PlannedView& view, const Pinhole& pinhole);

/// Moves the car to the view's place and renders with `pinhole`, which is the view's master camera or a
/// smaller one, by the recipe's samples and path length, with the scene's cache. `progress` is called after
/// each tile; what it throws ends the render.
RenderedView render_halves(const Recipe& recipe, const PlannedView& view, const Pinhole& pinhole,
                           LitScene& lit, const TileProgress& progress = {});

/// Likewise renders an image for each of these cameras, ray by ray through its lens, with the kernel that a
/// warp gives a pixel (a Gaussian of half a pixel) and four times the recipe's samples: an image pixel is
/// then as noisy as one that was warped from a master.
RenderedView trace_images(const Recipe& recipe, const PlannedView& view, std::span<const ModelCamera> cameras,
                          LitScene& lit, const TileProgress& progress = {});

}  // namespace cps
