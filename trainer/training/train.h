#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dataset/labels/reader.h"
#include "trainer/model/train_options.h"
#include "trainer/network/device.h"
#include "trainer/training/ranks.h"

namespace cps {

/// How one epoch went. Losses are mean squared errors of standardised targets: 1 is what the training mean
/// scores on the training set.
struct EpochReport {
  int epoch = 0, planned_epochs = 0;  ///< counted from 1
  double learning_rate = 0;           ///< at the epoch's last step
  double training_loss = 0;           ///< mean over the epoch's batches, while the weights moved
  double validation_loss = 0;
  double validation_cosine = 0;  ///< mean cosine similarity of standardised prediction and truth
  double validation_hfov_mae_deg = 0;
  double images_per_second = 0;  ///< while training
  double loader_share = 0;       ///< of that time, spent on making images ready
  double seconds_left = 0;
  bool is_best = false;  ///< smallest validation loss so far: these weights were kept
};

/// One line, aligned from epoch to epoch.
std::string to_string(const EpochReport& report);

struct TrainSummary {
  int training_images = 0, validation_images = 0;
  std::int64_t parameters = 0;
  double decode_seconds = 0, train_seconds = 0;  ///< of this run
  EpochReport best;
  std::vector<EpochReport> epochs;   ///< all, those before a resume included
  std::vector<std::string> skipped;  ///< one line for each image left out
  bool is_finished = false;          ///< false: stopped before the last planned epoch; a resume goes on

  std::string brief_report() const;
};

/// Called after every epoch; saying false stops there, and a later resume goes on as if nothing had happened.
using EpochCallback = std::function<bool(const EpochReport&)>;

/// Trains on dataset's `train` images, judging by its `val` images; its `test` images are not opened. Leaves
/// in model_folder: model.json and weights.pt (the best epoch's), state.pt (all that a resume needs),
/// history.csv, and the image caches. Every file appears by atomic rename.
///
/// With `resume`, goes on after the last whole epoch in model_folder, with that run's options (`options` is
/// not looked at): weights come out bit for bit as from an uninterrupted run, on the same machine with the
/// same number of threads. Without it, refuses a folder that already holds a model.
///
/// With options.minutes, the first epoch is timed and the number of planned epochs cut so that all fit, so
/// the learning rate still passes through its whole schedule; should the machine slow down, no epoch is
/// started once the budget is spent.
///
/// With several processes each calls this with the same arguments and sees the same dataset and folder; the
/// first writes. N processes make the weights that one makes of the same batches_per_step.
///
/// A run may go on on another device; the promise of equal weights holds for the CPU.
///
/// Throws std::runtime_error with one line on invalid options, unusable data, or a model of another dataset.
TrainSummary train(const Dataset& dataset, const std::filesystem::path& model_folder,
                   const TrainOptions& options, bool resume, const EpochCallback& on_epoch,
                   const Ranks& ranks = Ranks(), Device device = Device::cpu);

}  // namespace cps
