#pragma once

#include <cstdint>
#include <functional>
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
/// `picture(i)` is what is corrupted of set.images[i]: reduced for the network, or measured_picture() for a
/// network that takes orientation. Lengths are in pixels of the network's image in both cases; noise is that
/// of the pixels which are corrupted. `picture` is called from many threads.
std::vector<RobustnessRow> robustness(const Predictor& predictor, const EvaluationSet& set,
                                      const std::function<GrayImage(std::size_t i)>& picture,
                                      std::uint64_t seed);

}  // namespace cps
