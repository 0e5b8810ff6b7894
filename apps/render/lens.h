#pragma once

#include "apps/render/request.h"

namespace cps {

/// Cameras of a picture through a lens, and of the master that it can be warped from.
struct LensView {
  Camera seen;     ///< camera of the picture, with its lens
  Pinhole master;  ///< oversampled and padded; empty without a lens, and for lenses that have no flat master
  Eigen::AlignedBox2d ideal_box;         ///< on z = 1: part that the picture shows; certified there
  std::optional<double> shown_hfov_deg;  ///< to be printed: the label's, or what another family really shows
};

/// The view of the ideal camera through --lens, if given. With Brown–Conrady coefficients the ideal camera's
/// field of view is the base of a border-free crop, as in a dataset; with parameters of another family it is
/// the angle that the picture really shows along its middle row. A calibration file defines intrinsics
/// itself; they are scaled to --size. A line on stderr says where a fisheye sees nothing. Throws
/// std::runtime_error in one line for a lens that cannot be certified or does not see that far.
LensView lens_view(const RenderRequest& request, const Camera& ideal);

/// Renders the view: ray by ray through the lens (--lens-in-camera), or by warping a master.
OIIO::ImageBuf render_through(const RenderScene& scene, const LensView& view, const RenderRequest& request,
                              RenderSummary* summary, OIIO::ImageBuf* variance);

}  // namespace cps
