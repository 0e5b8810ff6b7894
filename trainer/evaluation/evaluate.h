#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "numbers/interval.h"
#include "trainer/evaluation/camera_evaluation.h"
#include "trainer/evaluation/coverage.h"
#include "trainer/evaluation/evaluated_image.h"
#include "trainer/evaluation/evaluation_bins.h"
#include "trainer/evaluation/evaluation_set.h"
#include "trainer/evaluation/ray_comparison.h"
#include "trainer/evaluation/robustness.h"
#include "trainer/evaluation/trusted_edges.h"
#include "trainer/model/predictor.h"

namespace cps {

/// How to measure.
struct EvaluationOptions {
  int resamples = 1000;          ///< of the bootstrap; 0: no intervals
  std::uint64_t seed = 0;        ///< seed of the bootstrap and of the noise in the robustness table
  bool robustness = false;       ///< measure the errors on corrupted images, too
  bool per_camera = false;       ///< join the images of each camera, too; needs a head with a fit
  bool skip_bad_images = false;  ///< leave out unreadable images and report them; otherwise they are an error

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// A number with its 95 % interval.
struct Estimate {
  double value = 0;
  Interval interval{};
};

/// The numbers that have intervals.
struct Headline {
  Estimate hfov_mean_deg, hfov_median_deg, hfov_correlation, reprojection_mean_px, reprojection_median_px;
  /// The network's mean error divided by that of always predicting the training mean: below 1 is better.
  Estimate hfov_ratio, reprojection_ratio;
  Estimate k1_r2;  ///< r_squared() of the network's k1 in apparent space
};

/// A network's errors beside those of two baselines that ignore the image.
struct Evaluation {
  std::string model;  ///< folder
  std::string set;
  LensErrors network;
  LensErrors
      training_mean;  ///< always predicts the mean of the training targets, in the model's target space
  LensErrors centre;  ///< predicts a centred principal point, no distortion, the training set's mean H-FOV
  Headline headline;
  RayComparison rays;                  ///< the numbers that compare lens families
  std::optional<Coverage> coverage{};  ///< of a head with a fit
  std::vector<EvaluationBin> bins;
  std::vector<CameraEvaluation> cameras;  ///< empty unless requested
  std::vector<RobustnessRow> robustness;  ///< empty unless requested
  std::vector<EvaluatedImage> images;
  std::vector<TrustedEdges> edges;   ///< of three of the images, for the page; only of a head with a fit
  std::vector<std::string> skipped;  ///< one line for each image that could not be read

  /// Aligned tables for the screen.
  std::string report() const;
};

/// Everything, for eval.json.
nlohmann::ordered_json to_json(const Evaluation& evaluation);

/// One self-contained HTML page with the tables, plots, the edges that the network trusts and the worst
/// images.
std::string to_html(const Evaluation& evaluation);

/// Runs the predictor, whose head must be brown_conrady, on the set and measures its errors. Throws
/// std::runtime_error with one line if an image is bad (unless bad images are skipped) or none is left, or if
/// `per_camera` is asked of a head without a fit.
Evaluation evaluate(const Predictor& predictor, const EvaluationSet& set,
                    const EvaluationOptions& options = {});

}  // namespace cps
