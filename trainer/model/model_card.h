#pragma once

#include <filesystem>
#include <string>

#include "trainer/calibration/lens_posterior.h"
#include "trainer/calibration/targets.h"
#include "trainer/deepcalib/sphere_target.h"
#include "trainer/images/orientation/orientation_statistics.h"
#include "trainer/images/pixel_statistics.h"
#include "trainer/model/train_options.h"

namespace cps {

/// Version of model.json.
inline constexpr int model_schema = 2;

/// Everything about a model except its weights: model.json in the model folder.
struct ModelCard {
  TrainOptions options;  ///< as trained, with architecture, input size and target space
  PixelStatistics pixels;
  OrientationStatistics orientation{};  ///< zeros without orientation
  Standardisation targets;              ///< of a brown_conrady head, in options.target_space
  OutputCovariance correlation = OutputCovariance::Identity();  ///< of the training targets
  SphereStatistics spheres{};                                   ///< of a DeepCalib head
  /// Of a head with a fit: what its standard deviations are multiplied by, so that they hold 68 % of the
  /// errors of the validation images.
  Outputs deviation_scale{1, 1, 1, 1, 1, 1, 1, 1};
  std::string dataset;       ///< folder of the training data
  std::string dataset_hash;  ///< dataset_fingerprint() of it
  int training_images = 0, validation_images = 0;
  int epoch = 0;                  ///< whose weights are kept, the best on the validation set; 0: none yet
  double validation_loss = 0;     ///< of that epoch
  bool has_half_weights = false;  ///< weights.pt is of half_weights_of(), as in a write_half_model() copy
};

/// Writes model.json by atomic rename.
void save_model_card(const ModelCard& card, const std::filesystem::path& model_folder);

/// Reads model.json. Throws std::runtime_error with one line if it is missing, incomplete, or of another
/// schema.
ModelCard load_model_card(const std::filesystem::path& model_folder);

}  // namespace cps
