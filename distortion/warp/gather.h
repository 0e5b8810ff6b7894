#pragma once

#include "distortion/warp/footprints.h"
#include "distortion/warp/pixel_bounds.h"
#include "distortion/warp/planar_patch.h"

namespace cps {

/// The kernels of a row of output pixels, their centres, and which source pixels they reach.
struct PlacedKernels {
  const double *x, *y;
  const KernelRow& kernels;
  const BoundsRow& bounds;
};

/// Sets `count` output pixels to the kernel-weighted means over their footprints, pixel after pixel with all
/// channels; 0 where the bounds say that nothing is to be gathered. Unchecked: the other bounds lie inside
/// the patch and contain at least one pixel centre of the ellipse.
void gather_row(const PlanarPatch& patch, const PlacedKernels& row, int count, float* pixels);

/// As gather_row(), but adds the means, each multiplied by its weight, to what the pixels are.
void add_gathered_row(const PlanarPatch& patch, const PlacedKernels& row, const float* weights, int count,
                      float* pixels);

}  // namespace cps
