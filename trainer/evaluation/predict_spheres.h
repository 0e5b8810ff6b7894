#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trainer/evaluation/ray_errors.h"
#include "trainer/model/predictor.h"

namespace cps {

/// The prediction of a network with a DeepCalib head for one image.
struct SpherePrediction {
  std::filesystem::path file;
  ModelCamera camera;                  ///< unified_spherical, of the image's size, named after the file
  double seen_hfov_rad = 0;            ///< along the middle row
  bool is_one_to_one = false;          ///< false: the lens does not show the whole frame
  std::optional<ModelCamera> truth{};  ///< of any lens family, from calibration.json beside the image
  RayErrors errors{};                  ///< against the truth
};

/// Runs the network on image files; results are in the order of `files`. Throws std::runtime_error with one
/// line if an image cannot be read, or a calibration.json beside it is invalid or of another image size.
std::vector<SpherePrediction> predict_spheres(const Predictor& predictor,
                                              std::span<const std::filesystem::path> files);

/// A few lines for each image.
std::string report(std::span<const SpherePrediction> predictions);

/// The predictions as a JSON array.
nlohmann::ordered_json to_json(std::span<const SpherePrediction> predictions);

}  // namespace cps
