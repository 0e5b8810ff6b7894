#pragma once

#include <OpenImageIO/imagebuf.h>

#include <Eigen/Core>
#include <functional>

#include "distortion/pinhole.h"

namespace cps {

/// A picture as a function on the plane z = 1.
using AnalyticScene = std::function<float(const Eigen::Vector2d& ideal)>;

/// A box-filtered render of the scene: each pixel is the mean over samples² points of its square. All
/// channels are equal.
inline OIIO::ImageBuf render_analytic(const AnalyticScene& scene, const Pinhole& camera, int samples,
                                      int channels = 1) {
  OIIO::ImageBuf image(OIIO::ImageSpec(camera.width, camera.height, channels, OIIO::TypeFloat));
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      double sum = 0;
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i)
          sum += scene(to_plane(camera, {x + (i + 0.5) / samples - 0.5, y + (j + 0.5) / samples - 0.5}));
      float* pixel = static_cast<float*>(image.pixeladdr(x, y));
      std::fill_n(pixel, channels, float(sum / (samples * samples)));
    }
  return image;
}

}  // namespace cps
