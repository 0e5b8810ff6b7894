#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "trainer/evaluation/evaluation_set.h"
#include "trainer/model/predictor.h"

namespace cps {

/// A network's errors under one kind of image corruption.
struct RobustnessRow {
  std::string name;  ///< "Gaussian blur, 2 px"
  double loss = 0;  ///< mean squared error of the learned outputs, standardised: predicting the training mean
                    ///< scores 1 on the training set
  double hfov_mean_deg = 0, reprojection_mean_px = 0;
};

/// Measures the errors on the images as they are, then under each corruption of the table in robustness.cpp.
/// Entry i of `images` is set.images[i], reduced for the network; lengths are in its pixels.
std::vector<RobustnessRow> robustness(const Predictor& predictor, const EvaluationSet& set,
                                      std::span<const GrayImage> images, std::uint64_t seed);

}  // namespace cps
