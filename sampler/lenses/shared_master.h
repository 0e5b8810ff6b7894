#pragma once

#include <span>

#include "sampler/lenses/lens_draw.h"

namespace cps {

/// The camera of one render for all these lenses, which have one image size: the widest base, with the warp's
/// pad, oversampled as far as the lens that magnifies most needs. That is twofold if the lenses share their
/// base; if they share the label's H-FOV and bases differ, a lens with a narrow base sees fewer pixels of the
/// render and may need more. Takes at least one lens; all have λ_min ≥ min_eigenvalue.
Pinhole shared_master(std::span<const DrawnLens> lenses, double min_eigenvalue);

}  // namespace cps
