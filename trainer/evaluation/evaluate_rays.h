#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "trainer/evaluation/evaluate.h"
#include "trainer/evaluation/ray_comparison.h"
#include "trainer/evaluation/ray_set.h"
#include "trainer/model/predictor.h"

namespace cps {

/// One image with the prediction of the network, and the errors of it and of the training mean.
struct RayEvaluatedImage {
  RayImage image;
  std::optional<ModelCamera> predicted;
  RayErrors network, training_mean;
};

/// A network's errors in ray space, whatever lens families it says and the pictures have.
struct RayEvaluation {
  std::string model;  ///< folder
  std::string set;
  RayComparison comparison;
  std::vector<RayEvaluatedImage> images;
  std::vector<std::string> skipped;  ///< one line for each image that could not be read

  /// Aligned lines for the screen.
  std::string report() const;
};

/// Everything, for eval.json.
nlohmann::ordered_json to_json(const RayEvaluation& evaluation);

/// One self-contained HTML page with the numbers and a plot.
std::string to_html(const RayEvaluation& evaluation);

/// Runs the predictor, with any head, on the set and measures its errors; options.robustness is not used.
/// Throws std::runtime_error with one line if an image is bad (unless bad images are skipped) or none is
/// left.
RayEvaluation evaluate_rays(const Predictor& predictor, const RaySet& set,
                            const EvaluationOptions& options = {});

}  // namespace cps
