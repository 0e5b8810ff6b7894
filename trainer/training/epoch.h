#pragma once

#include <torch/types.h>

#include "trainer/model/model_card.h"
#include "trainer/training/epoch_report.h"
#include "trainer/training/ranks.h"
#include "trainer/training/samples.h"
#include "trainer/training/training_set.h"
#include "trainer/training/training_state.h"

namespace cps {

class Predictor;

/// Trains on each training image once, in this epoch's order. A step uses the mean gradient of
/// options.batches_per_step batches, each with its own batch normalisation; the processes divide them and all
/// get the same weights. The running statistics of batch normalisation are the mean over the step's batches.
/// Images are prepared one batch ahead, on another thread; what that throws, this throws. `teacher` may be
/// null. report.epoch is given; sets the report's learning rate, training loss, rate and loader share.
/// options.batches_per_step must be a multiple of the number of processes.
void train_epoch(TrainingState& state, const TrainingSet& set, const ModelCard& card,
                 const Predictor* teacher, const Ranks& ranks, EpochReport& report);

/// Runs `network` on the validation images, neither augmented nor mirrored, and sets the report's validation
/// results, which must be 0 before. Returns head_rows() of the images.
torch::Tensor validate(Network& network, const Samples& samples, const ModelCard& card, EpochReport& report);

}  // namespace cps
