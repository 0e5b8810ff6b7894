#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trainer/fit/convergence.h"
#include "trainer/fit/one_camera.h"
#include "trainer/model/predictor.h"

namespace cps {

/// What a network with a fit says of the one camera that took some pictures.
struct OneCameraPrediction {
  std::vector<std::filesystem::path> files;
  ImageSize size;                             ///< of each file
  OneCamera camera;                           ///< its frames are in the order of the files
  CalibratedCamera fitted;                    ///< of the posterior's mean
  Outputs deviation{};                        ///< raw standard deviations of `fitted`
  std::vector<ConvergencePoint> convergence;  ///< in TargetSpace::raw
  std::optional<CalibratedCamera> truth{};    ///< from a calibration.json beside the files
  std::optional<double> reprojection_px{};    ///< error of `fitted` against the truth
};

/// The size of all files. Throws std::runtime_error with one line that names two of different sizes, or one
/// that cannot be read.
ImageSize common_size(std::span<const std::filesystem::path> files);

/// The camera in the calibration.json beside the files, which may lie in several folders; empty if none has
/// one. Throws as truth_beside() does, and if two folders name different cameras.
std::optional<CalibratedCamera> common_truth(std::span<const std::filesystem::path> files,
                                             const ImageSize& size);

/// Runs the network on the files, of which there must be at least one, and joins what it says. `options` are
/// used with the deviation scale of the model. Throws std::runtime_error with one line if the network's head
/// has no fit, an image cannot be read, or as the two functions above do.
OneCameraPrediction predict_one_camera(const Predictor& predictor,
                                       std::span<const std::filesystem::path> files,
                                       OneCameraOptions options = {});

/// A table of the numbers, and how many pictures counted.
std::string report(const OneCameraPrediction& prediction);

/// Everything.
nlohmann::ordered_json to_json(const OneCameraPrediction& prediction);

/// How H-FOV, k1 and the standard deviations change with the number of pictures.
std::string convergence_svg(const OneCameraPrediction& prediction);

}  // namespace cps
