#pragma once

#include "trainer/model_card.h"
#include "trainer/samples.h"
#include "trainer/train.h"
#include "trainer/training_state.h"

namespace cps {

/// One pass over the training images, in this epoch's order. Fills in the report's learning rate, loss and
/// rate; its epoch is given.
void train_epoch(TrainingState& state, const Samples& samples, const ModelCard& card, EpochReport& report);

/// What `network` scores on the validation images, not augmented and not mirrored: the report's validation
/// numbers.
void validate(Network& network, const Samples& samples, const ModelCard& card, EpochReport& report);

}  // namespace cps
