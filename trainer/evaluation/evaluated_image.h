#pragma once

#include <optional>
#include <span>
#include <vector>

#include "trainer/evaluation/evaluation_set.h"
#include "trainer/evaluation/lens_errors.h"

namespace cps {

/// One image with the predictions of the network and of the two baselines.
struct EvaluatedImage {
  EvaluationImage image;
  Outputs predicted{};  ///< by the network, raw
  ImageErrors network, training_mean, centre;
  /// The prediction's standard deviations, raw and apparent; only of a head with a fit.
  std::optional<Outputs> deviation{}, apparent_deviation{};
};

/// summarise() of the chosen images' errors `of` one of the predictions; repeated images count repeatedly.
LensErrors summary_of(std::span<const EvaluatedImage> images, std::span<const int> chosen,
                      ImageErrors EvaluatedImage::*of);

/// Indices of all images, the smallest reprojection error of the network first. Predictions that are not a
/// camera, which have none, are the last.
std::vector<int> by_reprojection_error(std::span<const EvaluatedImage> images);

}  // namespace cps
