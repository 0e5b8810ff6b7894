#pragma once

#include <span>
#include <string>
#include <vector>

#include "trainer/evaluation/evaluated_image.h"
#include "trainer/fit/lens_fit.h"
#include "trainer/images/batches.h"
#include "trainer/model/predictor.h"

namespace cps {

/// The edges of one image with the weights that a network gives them, and those of the camera fitted to them.
struct TrustedEdges {
  std::string rank;  ///< by reprojection error: "best", "median" or "worst"
  int image = 0;     ///< its place among the evaluated images
  FrameEvidence evidence{};
  TiltModel model{};  ///< at the parameters of fit_lens()
};

/// Of the images with the smallest, the median and the largest reprojection error, as far as these are
/// different ones. `batch`: all images as the network takes them. Needs at least one image. Throws as
/// Predictor::evidence() does.
std::vector<TrustedEdges> trusted_edges(const Predictor& predictor, std::span<const EvaluatedImage> images,
                                        std::span<const BatchImage> batch);

}  // namespace cps
