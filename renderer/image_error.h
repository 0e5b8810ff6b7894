#pragma once

#include <OpenImageIO/imagebuf.h>

namespace cps {

/// Difference of an image from a reference.
struct ImageError {
  double rmse = 0;     ///< root of the mean squared difference, in the image's unit
  double rel_mse = 0;  ///< mean of squared difference over squared reference (Rousselle et al. 2011); 1 % of
                       ///< the reference's mean square is added to the divisor, so that black pixels do not
                       ///< dominate
  double bias = 0;     ///< mean difference over mean reference
};

/// Over the first three channels of both. Throws std::runtime_error if the sizes differ.
ImageError image_error(const OIIO::ImageBuf& image, const OIIO::ImageBuf& reference);

}  // namespace cps
