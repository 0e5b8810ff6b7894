#pragma once

#include <string>

namespace cps {

/// Results of one epoch. Losses are mean squared errors of standardised outputs: predicting the training mean
/// scores 1 on the training set. Those of a DeepCalib head are sphere_loss().
struct EpochReport {
  int epoch = 0, planned_epochs = 0;  ///< counted from 1
  double learning_rate = 0;           ///< at the epoch's last step
  double training_loss = 0;           ///< mean over the epoch's batches, while the weights changed
  double validation_loss = 0;
  double validation_cosine = 0;  ///< mean cosine similarity of standardised prediction and truth
  double validation_hfov_mae_deg = 0;
  double images_per_second = 0;  ///< while training
  double loader_share = 0;       ///< fraction of the training time spent waiting for images
  double seconds_left = 0;
  bool is_best = false;  ///< smallest validation loss so far: these weights were kept
};

/// Calls visit(name, field) for each field; `name` is the field's name in files.
template <typename Report, typename Visit>
void for_each_field(Report& report, Visit visit) {
  visit("epoch", report.epoch);
  visit("planned_epochs", report.planned_epochs);
  visit("learning_rate", report.learning_rate);
  visit("training_loss", report.training_loss);
  visit("validation_loss", report.validation_loss);
  visit("validation_cosine", report.validation_cosine);
  visit("validation_hfov_mae_deg", report.validation_hfov_mae_deg);
  visit("images_per_second", report.images_per_second);
  visit("loader_share", report.loader_share);
  visit("seconds_left", report.seconds_left);
  visit("is_best", report.is_best);
}

/// Progress line, aligned from epoch to epoch.
std::string to_string(const EpochReport& report);

}  // namespace cps
