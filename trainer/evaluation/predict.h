#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trainer/calibration/certified_lens.h"
#include "trainer/model/predictor.h"

namespace cps {

/// The prediction of a network for one image.
struct ImagePrediction {
  std::filesystem::path file;
  ImageSize size;                            ///< of the image file
  Outputs raw{};                             ///< TargetSpace::raw
  std::optional<CalibratedCamera> camera{};  ///< named after the file; empty: the H-FOV is outside 0…180°
  bool is_one_to_one = false;                ///< false: the predicted lens folds inside its frame
  Outputs spread{};                          ///< raw; see PredictOptions::variants
  std::optional<Outputs> deviation{};        ///< raw standard deviations; only of a head with a fit
  std::optional<CertifiedLens> certified{};  ///< pull_to_certified(*camera)
  std::optional<CalibratedCamera> truth{};   ///< from calibration.json beside the image
  std::optional<double> reprojection_px{};   ///< error against the truth
};

/// How to predict.
struct PredictOptions {
  /// Variants of each image (augmented(), every second one mirrored) whose predictions are compared: `spread`
  /// is the standard deviation over them. It measures how stable a prediction is, not how far it is from the
  /// truth. 0: none. With orientation, the changes are made to measured_picture(), whose pixels are smaller.
  int variants = 8;
  std::uint64_t seed = 0;  ///< of the random changes that make the variants
};

/// Runs the network on image files; results are in the order of `files`. Throws std::runtime_error with one
/// line if an image cannot be read, or a calibration.json beside it is invalid or of another image size.
std::vector<ImagePrediction> predict_images(const Predictor& predictor,
                                            std::span<const std::filesystem::path> files,
                                            const PredictOptions& options = {});

/// A table for each image, with the truth in a column of its own.
std::string report(std::span<const ImagePrediction> predictions);

/// The predictions as a JSON array.
nlohmann::ordered_json to_json(std::span<const ImagePrediction> predictions);

}  // namespace cps
