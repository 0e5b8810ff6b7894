#pragma once

#include <string>

#include "random/counter_hash.h"
#include "trainer/images/gray_image.h"

namespace cps {

/// Changes to a picture that leave its label exactly true: no pixel shows another point of the world than
/// before. (Rotation, scaling, cropping, shearing, translation would each need another label, and are not on
/// offer; nor is a lens effect of any kind.) Sizes are pixels of the network's image.
struct Augmentation {
  double probability = 0;          ///< of each of the changes, on its own, per image and epoch; 0: none
  double max_blur_sigma_px = 1.2;  ///< Gaussian blur
  double max_motion_blur_px = 6;   ///< length of a straight, centred streak
  double max_gamma = 1.6;          ///< exponent, log-uniform in [1/max, max]
  double max_iso_noise = 12;       ///< standard deviation at white, of 255
  int min_jpeg_quality = 35;
  double max_brightness = 30;  ///< added or taken, of 255
  double max_contrast = 1.4;   ///< about the middle, log-uniform in [1/max, max]
  double max_cutout = 0.25;    ///< sides of one gray rectangle, as a share of the image's

  bool is_valid(std::string* why) const;
  bool operator==(const Augmentation&) const = default;
};

/// The image as the network sees it in training: a pure function of the image, the options and `stream`.
GrayImage augmented(const GrayView& image, const Augmentation& options, Stream stream);

}  // namespace cps
