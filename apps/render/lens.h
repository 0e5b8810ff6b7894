#pragma once

#include "apps/render/request.h"

namespace cps {

/// A picture through a lens, and the master that it can be warped from.
struct LensView {
  Camera seen;                    ///< the picture's camera, its lens included
  Pinhole master;                 ///< oversampled and padded; empty without a lens
  Eigen::AlignedBox2d ideal_box;  ///< on z = 1: what the picture shows, where the lens is certified
};

/// The camera that was asked for behind its --lens, if any. Coefficients keep the ideal camera's field of
/// view as the base of a border-free crop, as in a dataset; a calibration file says what its picture's pixels
/// mean, and is scaled to another --size. Throws std::runtime_error in one line: the file, a lens that cannot
/// be certified.
LensView lens_view(const RenderRequest& request, const Camera& ideal);

/// The picture: through the lens ray by ray, or by warping a master.
OIIO::ImageBuf render_through(const RenderScene& scene, const LensView& view, const RenderRequest& request,
                              RenderSummary* summary, OIIO::ImageBuf* variance);

}  // namespace cps
