#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "trainer/evaluation/evaluation_set.h"
#include "trainer/model/predictor.h"

namespace cps {

/// How a network does when its images are spoilt.
struct RobustnessRow {
  std::string name;  ///< "Gaussian blur, 2 px"
  double loss = 0;   ///< mean squared error of the learned outputs, standardised: 1 is what the training mean
                     ///< scores on the training set
  double hfov_mean_deg = 0, reprojection_mean_px = 0;
};

/// The images as they are, then under each corruption of trainer/images/corruptions.h at its strengths;
/// pixels are the network's. `images` belong to set.images.
std::vector<RobustnessRow> robustness(const Predictor& predictor, const EvaluationSet& set,
                                      std::span<const GrayImage> images, std::uint64_t seed);

}  // namespace cps
