#pragma once

#include <span>

#include "sampler/lenses/lens_draw.h"

namespace cps {

/// The camera of one render that serves all these lenses, which have one size: the widest base, with the
/// warp's pad, oversampled as far as the most magnifying lens needs. With a base in common that is twice;
/// where the label is in common and bases differ, a lens of a narrow base sees fewer of the render's pixels
/// and may need more. At least one lens; all have λ_min ≥ min_eigenvalue.
Pinhole shared_master(std::span<const DrawnLens> lenses, double min_eigenvalue);

}  // namespace cps
