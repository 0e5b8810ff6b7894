#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dataset/labels/reader.h"
#include "trainer/model/train_options.h"
#include "trainer/network/device.h"
#include "trainer/network/precision.h"
#include "trainer/training/epoch_report.h"
#include "trainer/training/ranks.h"

namespace cps {

/// Results of one run.
struct TrainSummary {
  int training_images = 0, validation_images = 0;
  std::int64_t parameters = 0;
  double decode_seconds = 0, train_seconds = 0;  ///< of this run
  Precision precision = Precision::float32;      ///< in which it computed
  std::string precision_line;                    ///< says so, and on the CPU what the processors could do
  EpochReport best;
  std::vector<EpochReport> epochs;   ///< all, with those before a resume
  std::vector<std::string> skipped;  ///< one line for each image left out
  bool is_finished = false;          ///< false: stopped before the last planned epoch; a resume continues

  /// Three lines for the screen.
  std::string brief_report() const;
};

/// Progress callback, called after every epoch. Returning false stops the training there; a later resume
/// continues as if it had not stopped.
using EpochCallback = std::function<bool(const EpochReport&)>;

/// Trains on the dataset's `train` images, or those of options.places_share of their places, and selects
/// weights by its `val` images; its `test` images are not opened. Writes to model_folder: model.json and
/// weights.pt (the best epoch's), state.pt (everything that a resume needs), history.csv, history.svg, and
/// the image caches. Every file appears by atomic rename. A model.onnx of earlier weights is removed.
///
/// With `resume`, continues after the last complete epoch in model_folder with that run's options (`options`
/// is ignored), in the precision that it chose. On the same machine with the same number of threads, the
/// weights equal those of an uninterrupted run bit for bit. Without `resume`, refuses a folder that already
/// holds a model.
///
/// With options.minutes, times the first epoch and reduces the number of planned epochs so that all fit; the
/// learning rate still runs through its whole schedule. If the machine slows down later, no epoch is started
/// once the time is used up.
///
/// The precision `automatic` becomes bfloat16 on the CPU if every process' processor computes it, else
/// float32; model.json and state.pt record what it became.
///
/// With several processes, each calls this with the same arguments and sees the same dataset and folder; rank
/// 0 writes. N processes give the same weights as one with the same batches_per_step.
///
/// A run may be resumed on another device; equal weights are promised for the CPU only.
///
/// Throws std::runtime_error with one line on invalid options, unusable data, labels that the head cannot
/// learn (require_learnable()), or a model of another dataset.
TrainSummary train(const Dataset& dataset, const std::filesystem::path& model_folder,
                   const TrainOptions& options, bool resume, const EpochCallback& on_epoch,
                   const Ranks& ranks = Ranks(), Device device = Device::cpu);

}  // namespace cps
