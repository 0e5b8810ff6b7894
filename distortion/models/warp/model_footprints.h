#pragma once

#include "distortion/models/warp/proved_camera.h"
#include "distortion/warp/footprints.h"

namespace cps {

/// Footprints in a picture of `source` of the pixels in `rect` of a picture that `output` takes from the same
/// place; `rect` is at most FootprintTile::side wide and high. Each pixel is unprojected by the output's lens
/// and projected by the source's; A is the product of both Jacobians. A pixel whose ray is not in both
/// regions gets NaN as its centre. `sigma_px` is the kernel's standard deviation, output pixels.
void model_footprints(const ProvedCamera& source, const ProvedCamera& output, double sigma_px,
                      const TileRect& rect, FootprintTile& tile);

}  // namespace cps
