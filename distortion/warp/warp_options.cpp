#include "distortion/warp/warp_options.h"

namespace cps {

std::string WarpOptions::fault() const {
  if (!(oversampling >= 1 && oversampling <= 8)) return "oversampling: must lie between 1 and 8";
  if (!(kernel_sigma_px >= 0.3 && kernel_sigma_px <= 4)) return "kernel_sigma_px: must lie between 0.3 and 4";
  return "";
}

}  // namespace cps
