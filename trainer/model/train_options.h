#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "trainer/calibration/targets.h"
#include "trainer/images/augmentation.h"
#include "trainer/images/gray_image.h"

namespace cps {

/// What training makes small. The first two are of standardised outputs.
enum class Loss {
  mse,
  huber,        ///< quadratic up to one deviation, linear beyond (Huber 1964)
  reprojection  ///< mean pixel distance between true and predicted lens, in hundredths of the image's width
};

std::string to_string(Loss loss);
/// Throws std::runtime_error on any other word.
Loss loss_from_string(const std::string& word);

struct TrainOptions {
  std::string architecture = "resnet18";
  std::string initial_weights;  ///< a file that start_from() reads; empty: drawn
  bool size_features = true;    ///< the network is told the original image's size
  bool edge_channel = false;    ///< the network sees each image's Sobel edges beside it
  TargetSpace target_space = TargetSpace::apparent;
  /// Of output_names: those that are learned; the others stay at their training mean.
  std::vector<std::string> outputs{output_names.begin(), output_names.end()};
  Loss loss = Loss::mse;
  Reduction reduction;
  int epochs = 20;
  int batch_size = 16;
  int batches_per_step = 1;  ///< their mean gradient makes a step; a multiple of the number of processes
  double learning_rate = 1e-3;
  double weight_decay = 0.01;
  /// Linear from 0 over the first epochs, counted in epochs and fractions of one.
  double warm_up_epochs = 1;
  /// The learning rate is multiplied by `decay` at each of these fractions of the planned epochs.
  std::vector<double> milestones{0.6, 0.85};
  double decay = 0.1;
  double dropout = 0;            ///< of the features before the last layer
  double max_gradient = 1;       ///< gradients of larger norm are scaled down to it; 0: never
  bool skip_bad_images = false;  ///< leave out images that cannot be used, and say so; else they are an error
  bool mirror = true;            ///< show every second image flipped, with its exact label
  Augmentation augmentation;
  bool online_lenses = false;   ///< learn from the dataset's kept masters, a new lens for each in every epoch
  double online_zoom = 1.3;     ///< OnlineLensOptions::zoom
  std::string teacher;          ///< folder of a trained model to learn from as well; empty: none
  double teacher_weight = 0.5;  ///< share of distillation_loss() in the loss; the labels have the rest
  double ema_decay = 0;  ///< of a running mean of the weights, which is then what is judged and kept; 0: none
  int patience = 0;      ///< stop after so many epochs without a better validation loss; 0: never
  std::uint64_t seed = 0;
  int threads = 0;     ///< 0: all cores
  double minutes = 0;  ///< wall budget; 0: none. See train()

  bool is_valid(std::string* why) const;
  bool operator==(const TrainOptions&) const = default;
};

nlohmann::ordered_json to_json(const TrainOptions& options);
/// Throws nlohmann::json::exception on a missing key or wrong type. Options that came later may be missing:
/// such a model was trained with their defaults.
TrainOptions train_options_from_json(const nlohmann::json& json);

/// The learning rate at `progress` epochs (fractions included) of `planned_epochs`. A pure function: a
/// resumed run needs no scheduler state.
double learning_rate_at(const TrainOptions& options, double progress, int planned_epochs);

}  // namespace cps
