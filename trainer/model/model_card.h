#pragma once

#include <filesystem>
#include <string>

#include "trainer/calibration/targets.h"
#include "trainer/images/pixel_statistics.h"
#include "trainer/model/train_options.h"

namespace cps {

/// Everything about a model but its weights: the model folder's model.json.
struct ModelCard {
  TrainOptions options;  ///< as trained: architecture, input size and target space among them
  PixelStatistics pixels;
  Standardisation targets;   ///< in options.target_space
  std::string dataset;       ///< where it was trained
  std::string dataset_hash;  ///< dataset_fingerprint() of it
  int training_images = 0, validation_images = 0;
  int epoch = 0;               ///< whose weights are kept: the best on the validation set; 0: none yet
  double validation_loss = 0;  ///< of that epoch
};

void save_model_card(const ModelCard& card, const std::filesystem::path& model_folder);

/// Throws std::runtime_error with one line when model.json is missing or lacks something.
ModelCard load_model_card(const std::filesystem::path& model_folder);

}  // namespace cps
