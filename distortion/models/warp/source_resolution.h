#pragma once

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/model_camera.h"
#include "distortion/panorama/equirectangular.h"

/// How many source pixels an output pixel has where it has the fewest, per axis: what a kernel needs to be
/// resolved (largest_magnification() in warp/master_camera.h is the inverse of that).
namespace cps {

/// The smallest singular value of ∂source pixel/∂output pixel over a grid of 33 × 33 points of the output's
/// frame, its rim included. Points that one of the two lenses does not show are left out; infinite if there
/// are no others. The regions must be proved for the two lenses (not checked).
double fewest_source_px(const ModelCamera& source, const RayRegion& source_region, const ModelCamera& output,
                        const RayRegion& output_region);

/// The same of a picture taken of an equirectangular panorama, by the panorama's coarsest pixels, those at
/// its equator: it does not depend on where the camera looks.
double fewest_panorama_px(const Panorama& panorama, const ModelCamera& output, const RayRegion& region);

}  // namespace cps
