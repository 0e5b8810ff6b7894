#pragma once

#include <OpenImageIO/imagebuf.h>

namespace cps {

/// How far an image is from a reference.
struct ImageError {
  double rmse = 0;     ///< root of the mean squared difference, in the image's unit
  double rel_mse = 0;  ///< mean of squared difference over squared reference (Rousselle et al. 2011), a
                       ///< hundredth of the reference's mean square added below so that black does not rule
  double bias = 0;     ///< mean difference over mean reference
};

/// Over the first three channels of both. Throws std::runtime_error if the sizes differ.
ImageError image_error(const OIIO::ImageBuf& image, const OIIO::ImageBuf& reference);

}  // namespace cps
