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

/// What a network says of one image.
struct ImagePrediction {
  std::filesystem::path file;
  ImageSize size;                            ///< the image's own
  Outputs raw{};                             ///< TargetSpace::raw
  std::optional<Calibration> calibration{};  ///< empty: the numbers are no camera
  bool is_one_to_one = false;                ///< false: the predicted lens folds inside its frame
  Outputs spread{};                          ///< raw; see PredictOptions::looks
  std::optional<CertifiedLens> certified{};  ///< pull_to_certified(*calibration)
  std::optional<Calibration> truth{};        ///< of calibration.json beside the image
  std::optional<double> reprojection_px{};   ///< error against the truth
};

struct PredictOptions {
  /// Further looks at each image, label-safe changes of it (augmented(), every second one mirrored): `spread`
  /// is the standard deviation of what the network says of them. It tells how firm a prediction is, not how
  /// far it is from the truth. 0: none.
  int looks = 8;
  std::uint64_t seed = 0;  ///< of the looks
};

/// In the order of `files`. Throws std::runtime_error with one line when an image cannot be read, or a
/// calibration.json beside it is wrong or says another size.
std::vector<ImagePrediction> predict_images(const Predictor& predictor,
                                            std::span<const std::filesystem::path> files,
                                            const PredictOptions& options = {});

/// Aligned, one image after the other; the truth in a second column.
std::string report(std::span<const ImagePrediction> predictions);

nlohmann::ordered_json to_json(std::span<const ImagePrediction> predictions);

}  // namespace cps
