#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "dataset/reader.h"
#include "trainer/lens_errors.h"
#include "trainer/predictor.h"

namespace cps {

/// A network's errors beside those of two predictors that look at nothing.
struct Evaluation {
  std::string model, dataset;  ///< folders
  Part part = Part::test;
  LensErrors network;
  LensErrors training_mean;  ///< always says the mean of the training targets, in the model's target space
  LensErrors centre;         ///< centred principal point, no distortion, the training set's mean H-FOV

  /// Aligned tables for a person.
  std::string report() const;
};

nlohmann::ordered_json to_json(const Evaluation& evaluation);

/// Throws std::runtime_error with one line when the part is empty, an image is bad, or a label's lens is not
/// one-to-one.
Evaluation evaluate(const Predictor& predictor, const Dataset& dataset, Part part);

}  // namespace cps
