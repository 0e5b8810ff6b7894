#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

#include "scenes/scene.h"

namespace cps {

/// A picture of a scene from above, 8-bit sRGB, at most `max_side_px` wide and high (at least 64): its
/// surfaces in their colours with shadows, its lanes as coloured lines that begin with a dot, a scale bar,
/// and `caption` below. −z is up and +x right. Shows the whole scene without what encloses it; of a scene
/// more than twice as large as its lanes reach, what lies around them. Throws std::runtime_error if Embree
/// cannot build its tree.
OIIO::ImageBuf top_view(const Scene& scene, const std::string& caption, int max_side_px);

}  // namespace cps
