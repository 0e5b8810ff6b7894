#pragma once

#include <string>

#include "random/counter_hash.h"
#include "trainer/images/gray_image.h"

namespace cps {

/// Random changes to a training image that keep its label exact: every pixel still shows the same point of
/// the world. (Rotation, scaling, cropping, shearing, translation and lens effects would change the label, so
/// they are not offered.) Sizes are in pixels of the picture that is changed.
struct Augmentation {
  double probability = 0;          ///< of each change, independently, per image and epoch; 0: none
  double max_blur_sigma_px = 1.2;  ///< Gaussian blur
  double max_motion_blur_px = 6;   ///< length of a straight streak, centred on the pixel
  double max_gamma = 1.6;          ///< largest exponent; drawn log-uniform in [1/max, max]
  double max_iso_noise = 12;       ///< largest standard deviation at white, in 8-bit steps
  int min_jpeg_quality = 35;
  double max_brightness = 30;  ///< largest amount added or subtracted, in 8-bit steps
  double max_contrast = 1.4;   ///< largest factor about mid-grey; drawn log-uniform in [1/max, max]
  double max_cutout = 0.25;    ///< largest sides of one gray rectangle, as a fraction of the image's

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
  bool operator==(const Augmentation&) const = default;
};

/// The image after the random changes: a pure function of the image, the options and `stream`.
GrayImage augmented(const GrayView& image, const Augmentation& options, Stream stream);

}  // namespace cps
