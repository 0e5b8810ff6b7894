#pragma once

#include <functional>

#include "distortion/image_size.h"
#include "distortion/pinhole.h"
#include "distortion/tile_rect.h"
#include "distortion/warp/footprints.h"

/// How far to zoom in so that a view of a source has no black border.
namespace cps {

/// Fills the tile's footprints for the pixels of `view` in `rect`.
using ViewFootprints = std::function<void(const Pinhole& view, const TileRect& rect, FootprintTile& tile)>;

/// Whether every pixel on the view's rim finds its whole footprint in a source of this size; the pixels
/// inside the rim then do too, since lenses are one-to-one where footprints exist.
bool is_rim_covered(const ViewFootprints& footprints, const Pinhole& view, const ImageSize& source);

/// The camera with its focal lengths multiplied by `zoom`.
Pinhole zoomed(const Pinhole& camera, double zoom);

/// The smallest zoom of `view`, at least `min_zoom`, at which its rim is covered; infinite if none is below
/// 1000 · min_zoom.
double smallest_covered_zoom(const ViewFootprints& footprints, const Pinhole& view, const ImageSize& source,
                             double min_zoom);

}  // namespace cps
