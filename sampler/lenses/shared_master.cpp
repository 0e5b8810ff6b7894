#include "sampler/lenses/shared_master.h"

#include <algorithm>

#include "distortion/warp/master_camera.h"

namespace cps {

Pinhole shared_master(std::span<const DrawnLens> lenses, double min_eigenvalue) {
  const Pinhole& widest = std::min_element(lenses.begin(), lenses.end(), [](const auto& a, const auto& b) {
                            return a.base.fx < b.base.fx;
                          })->base;
  double magnification = 0;
  for (const DrawnLens& lens : lenses)
    magnification =
        std::max(magnification, lens.crop.camera.fx / widest.fx * lens.crop.certificate.max_eigenvalue);
  WarpOptions options;
  // A little more than needed, so that rounding does not decide.
  options.oversampling *= std::max(1.0, 1.0001 * magnification / largest_magnification(options));
  return master_camera(widest, options, min_eigenvalue);
}

}  // namespace cps
