#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trainer/predictor.h"

namespace cps {

/// What a network says of one image.
struct ImagePrediction {
  std::filesystem::path file;
  ImageSize size;                            ///< the image's own
  Outputs raw{};                             ///< TargetSpace::raw
  std::optional<Calibration> calibration{};  ///< empty: the numbers are no camera
  bool is_one_to_one = false;                ///< false: the predicted lens folds inside its frame
  std::optional<Calibration> truth{};        ///< of calibration.json beside the image
  std::optional<double> reprojection_px{};   ///< error against the truth
};

/// In the order of `files`. Throws std::runtime_error with one line when an image cannot be read, or a
/// calibration.json beside it is wrong or says another size.
std::vector<ImagePrediction> predict_images(const Predictor& predictor,
                                            std::span<const std::filesystem::path> files);

/// Aligned, one image after the other; the truth in a second column.
std::string report(std::span<const ImagePrediction> predictions);

nlohmann::ordered_json to_json(std::span<const ImagePrediction> predictions);

}  // namespace cps
