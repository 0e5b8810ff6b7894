#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "trainer/gray_image.h"
#include "trainer/targets.h"

namespace cps {

struct TrainOptions {
  std::string architecture = "resnet18";
  TargetSpace target_space = TargetSpace::apparent;
  Reduction reduction;
  int epochs = 20;
  int batch_size = 16;
  double learning_rate = 1e-3;
  double weight_decay = 0.01;
  /// Linear from 0 over the first epochs, counted in epochs and fractions of one.
  double warm_up_epochs = 1;
  /// The learning rate is multiplied by `decay` at each of these fractions of the planned epochs.
  std::vector<double> milestones{0.6, 0.85};
  double decay = 0.1;
  double dropout = 0;       ///< of the features before the last layer
  double max_gradient = 1;  ///< gradients of larger norm are scaled down to it; 0: never
  bool mirror = true;       ///< show every second image flipped, with its exact label
  std::uint64_t seed = 0;
  int threads = 0;     ///< 0: all cores
  double minutes = 0;  ///< wall budget; 0: none. See train()

  bool is_valid(std::string* why) const;
  bool operator==(const TrainOptions&) const = default;
};

nlohmann::ordered_json to_json(const TrainOptions& options);
/// Throws nlohmann::json::exception on a missing key or wrong type.
TrainOptions train_options_from_json(const nlohmann::json& json);

/// The learning rate at `progress` epochs (fractions included) of `planned_epochs`. A pure function: a
/// resumed run needs no scheduler state.
double learning_rate_at(const TrainOptions& options, double progress, int planned_epochs);

}  // namespace cps
