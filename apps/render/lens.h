#pragma once

#include "apps/render/request.h"

namespace cps {

/// Cameras of a picture through a lens, and of the master that it can be warped from.
struct LensView {
  Camera seen;                    ///< camera of the picture, with its lens
  Pinhole master;                 ///< oversampled and padded; empty without a lens
  Eigen::AlignedBox2d ideal_box;  ///< on z = 1: part that the picture shows; the lens is certified there
};

/// The view of the ideal camera through --lens, if given. With coefficients the ideal camera's field of view
/// is the base of a border-free crop, as in a dataset. A calibration file defines intrinsics itself; they are
/// scaled to --size. Throws std::runtime_error in one line for a file that cannot be read or a lens that
/// cannot be certified.
LensView lens_view(const RenderRequest& request, const Camera& ideal);

/// Renders the view: ray by ray through the lens (--lens-in-camera), or by warping a master.
OIIO::ImageBuf render_through(const RenderScene& scene, const LensView& view, const RenderRequest& request,
                              RenderSummary* summary, OIIO::ImageBuf* variance);

}  // namespace cps
