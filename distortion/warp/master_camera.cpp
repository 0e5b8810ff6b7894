#include "distortion/warp/master_camera.h"

#include <cmath>

#include "distortion/warp/footprints.h"

namespace cps {

int master_pad(const WarpOptions& options, double min_eigenvalue) {
  return int(std::ceil(kernel_support * options.kernel_sigma_px * options.oversampling / min_eigenvalue));
}

Pinhole master_camera(const Pinhole& base, const WarpOptions& options, double min_eigenvalue) {
  return oversampled(base, options.oversampling, master_pad(options, min_eigenvalue));
}

double largest_magnification(const WarpOptions& options) {
  // sigma² (oversampling / magnification)² − 1/12 ≥ narrowest².
  return options.oversampling * options.kernel_sigma_px /
         std::sqrt(1.0 / 12 + narrowest_sigma_px * narrowest_sigma_px);
}

}  // namespace cps
