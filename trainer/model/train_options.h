#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "trainer/calibration/targets.h"
#include "trainer/images/augmentation.h"
#include "trainer/images/gray_image.h"
#include "trainer/images/orientation/orientation.h"
#include "trainer/model/head.h"
#include "trainer/network/precision.h"

namespace cps {

/// The training loss. The first two compare standardised outputs.
enum class Loss {
  mse,          ///< mean squared error
  huber,        ///< quadratic up to one deviation, linear beyond (Huber 1964)
  reprojection  ///< mean pixel distance between true and predicted lens, in hundredths of the image's width
};

std::string to_string(Loss loss);
/// Throws std::runtime_error on any other word.
Loss loss_from_string(const std::string& word);

/// How to train a network, and which.
struct TrainOptions {
  std::string architecture = "resnet18";
  std::string initial_weights = {};  ///< a file for start_from(); empty: random weights
  bool size_features = true;         ///< give the network the size of the original image
  bool edge_channel = false;         ///< give the network each image's Sobel edges as a second channel
  OrientationOptions orientation{};  ///< give the network the orientation of edges at the image's own size
  Head head = Head::brown_conrady;   ///< the DeepCalib ones have targets and a loss of their own
  TargetSpace target_space = TargetSpace::apparent;
  /// The learned outputs, from output_names; the others stay at their training mean.
  std::vector<std::string> outputs{output_names.begin(), output_names.end()};
  Loss loss = Loss::mse;
  Reduction reduction{};
  int epochs = 20;
  int batch_size = 16;
  int batches_per_step = 1;  ///< a step uses their mean gradient; a multiple of the number of processes
  double learning_rate = 1e-3;
  double weight_decay = 0.01;
  /// The learning rate rises linearly from 0 over so many epochs.
  double warm_up_epochs = 1;
  /// The learning rate is multiplied by `decay` at each of these fractions of the planned epochs.
  std::vector<double> milestones{0.6, 0.85};
  double decay = 0.1;
  double dropout = 0;            ///< probability, on the features before the last layer
  double max_gradient = 1;       ///< gradients of larger norm are scaled down to it; 0: never
  bool skip_bad_images = false;  ///< leave out unusable images and report them; otherwise they are an error
  double places_share = 1;       ///< train on the images of such a share of the training places alone
  bool mirror = true;            ///< flip a random half of the images in each epoch, with exact labels
  Augmentation augmentation{};
  bool online_lenses = false;   ///< train on the dataset's kept masters, each with a new lens in every epoch
  double online_zoom = 1.3;     ///< OnlineLensOptions::zoom
  std::string teacher = {};     ///< model folder of a network to learn from, too (distillation); empty: none
  double teacher_weight = 0.5;  ///< weight of distillation_loss() in the loss; the labels have the rest
  double ema_decay = 0;    ///< of a running mean of the weights, which is then validated and saved; 0: none
  int patience = 0;        ///< stop after so many epochs without a better validation loss; 0: never
  std::uint64_t seed = 0;  ///< of all random choices
  int threads = 0;         ///< 0: all cores
  Precision precision = Precision::float32;  ///< of the convolutions in training
  double minutes = 0;                        ///< time budget, wall clock; 0: none. See train()

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
  bool operator==(const TrainOptions&) const = default;
};

/// Every option under its name in model.json; the orientation only where it is measured, the precision only
/// where it is not float32, the head only where it is not brown_conrady, and the share of the places only
/// where it is not 1, so that the cards of networks without them stay as they were.
nlohmann::ordered_json to_json(const TrainOptions& options);

/// Reads what to_json() wrote. Throws nlohmann::json::exception on a missing key or wrong type. Options that
/// were added later may be missing: older models were trained with their defaults.
TrainOptions train_options_from_json(const nlohmann::json& json);

/// The learning rate after `progress` epochs (a fraction counts) of `planned_epochs`. A pure function, so a
/// resumed run needs no scheduler state.
double learning_rate_at(const TrainOptions& options, double progress, int planned_epochs);

}  // namespace cps
