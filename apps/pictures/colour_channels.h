#pragma once

#include <OpenImageIO/imagebuf.h>
#include <tbb/parallel_for.h>

namespace cps {

/// Applies `change(value, alpha)` to all channels of a float picture other than alpha.
template <typename Change>
void change_colours(OIIO::ImageBuf& image, int alpha, Change change) {
  const OIIO::ImageSpec& spec = image.spec();
  tbb::parallel_for(0, spec.height, [&](int y) {
    auto* pixel = static_cast<float*>(image.pixeladdr(spec.x, spec.y + y));
    for (int x = 0; x < spec.width; ++x, pixel += spec.nchannels)
      for (int channel = 0; channel < spec.nchannels; ++channel)
        if (channel != alpha) pixel[channel] = change(pixel[channel], alpha < 0 ? 1.0f : pixel[alpha]);
  });
}

}  // namespace cps
