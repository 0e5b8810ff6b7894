#pragma once

#include "trainer/model/model_card.h"
#include "trainer/training/ranks.h"
#include "trainer/training/samples.h"
#include "trainer/training/train.h"
#include "trainer/training/training_set.h"
#include "trainer/training/training_state.h"

namespace cps {

class Predictor;

/// One pass over the training images, in this epoch's order. A step takes the mean gradient of
/// options.batches_per_step batches, each with its own batch normalisation; the processes share them out, and
/// all end with the same weights. Statistics of batch normalisation are the mean of what each batch makes of
/// them. `teacher` may be null. Fills in the report's learning rate, loss and rate; its epoch is given.
void train_epoch(TrainingState& state, const TrainingSet& set, const ModelCard& card,
                 const Predictor* teacher, const Ranks& ranks, EpochReport& report);

/// What `network` scores on the validation images, not augmented and not mirrored: the report's validation
/// numbers.
void validate(Network& network, const Samples& samples, const ModelCard& card, EpochReport& report);

}  // namespace cps
