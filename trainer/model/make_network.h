#pragma once

#include <memory>

#include "trainer/model/train_options.h"
#include "trainer/network/resnet.h"

namespace cps {

/// What make_resnet() has to know of the options, apart from the architecture.
NetworkOptions network_options(const TrainOptions& options);

/// A network as the options describe it: architecture, inputs, dropout. Its initial weights come from torch's
/// global generator; options.initial_weights are not read.
std::shared_ptr<Network> make_network(const TrainOptions& options);

}  // namespace cps
