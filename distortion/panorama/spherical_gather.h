#pragma once

#include <OpenImageIO/imagebuf.h>

#include <vector>

#include "distortion/panorama/spherical_footprint.h"

namespace cps {

/// An equirectangular picture as floats, and sines and cosines of the angles of its rows and columns.
class SphericalPicture {
 public:
  /// Reads the pixels of a float image where they are, which must then outlive this; converts others.
  /// Unchecked: the image is in memory, twice as wide as high, and has 1 to 4 channels.
  explicit SphericalPicture(const OIIO::ImageBuf& image);

  const Panorama& size() const { return size_; }

  /// Sets a pixel with all channels to the kernel-weighted mean of the picture's pixels, each counted as much
  /// as its share of the sphere, across the seam and the poles. Unchecked: the footprint reaches
  /// widest_reach_rad at most.
  void gather(const SphericalFootprint& footprint, float* pixel) const;

 private:
  template <int channels>
  void gather_channels(const SphericalFootprint& footprint, float* pixel) const;

  Panorama size_;
  int channels_;
  std::vector<float> converted_;
  std::vector<const float*> rows_;
  std::vector<double> sine_longitude_, cosine_longitude_;  ///< by column
  std::vector<double> sine_latitude_, cosine_latitude_;    ///< by row
};

}  // namespace cps
