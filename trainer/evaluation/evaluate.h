#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "numbers/interval.h"
#include "trainer/evaluation/evaluation_set.h"
#include "trainer/evaluation/lens_errors.h"
#include "trainer/evaluation/robustness.h"
#include "trainer/model/predictor.h"

namespace cps {

struct EvaluationOptions {
  int resamples = 1000;    ///< of the bootstrap; 0: no intervals
  std::uint64_t seed = 0;  ///< of the bootstrap and of the noise in the table of robustness
  bool robustness = false;
  bool skip_bad_images = false;  ///< leave out what cannot be read, and say so; else it is an error
  bool is_valid(std::string* why) const;
};

/// One image and what was said of it by the network and by the two predictors that look at nothing.
struct EvaluatedImage {
  EvaluationImage image;
  Outputs said{};  ///< raw
  ImageErrors network, training_mean, centre;
};

/// A part of the images.
struct EvaluationBin {
  std::string kind, name;  ///< "H-FOV" "60–70°"; "size" "348x128"; "camera" "front"
  int images = 0;
  LensErrors network, training_mean;
};

/// A number with its 95 % interval.
struct Estimate {
  double value = 0;
  Interval interval{};
};

/// The numbers that intervals are given for.
struct Headline {
  Estimate hfov_mean_deg, hfov_median_deg, hfov_correlation, reprojection_mean_px, reprojection_median_px;
  /// Network's mean by the training mean's: below 1 is better than looking at nothing.
  Estimate hfov_ratio, reprojection_ratio;
};

/// A network's errors beside those of two predictors that look at nothing.
struct Evaluation {
  std::string model;  ///< folder
  std::string set;
  LensErrors network;
  LensErrors training_mean;  ///< always says the mean of the training targets, in the model's target space
  LensErrors centre;         ///< centred principal point, no distortion, the training set's mean H-FOV
  Headline headline;
  std::vector<EvaluationBin> bins;
  std::vector<RobustnessRow> robustness;  ///< empty unless asked for
  std::vector<EvaluatedImage> images;
  std::vector<std::string> skipped;  ///< one line for each image that could not be read

  /// Aligned tables for a person.
  std::string report() const;
};

nlohmann::ordered_json to_json(const Evaluation& evaluation);

/// The same as one self-contained page with plots and the worst images.
std::string to_html(const Evaluation& evaluation);

/// Throws std::runtime_error with one line when an image is bad (unless they are skipped) or none is left.
Evaluation evaluate(const Predictor& predictor, const EvaluationSet& set,
                    const EvaluationOptions& options = {});

}  // namespace cps
