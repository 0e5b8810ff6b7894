#pragma once

#include <span>
#include <vector>

#include "trainer/calibration/targets.h"
#include "trainer/images/batches.h"
#include "trainer/model/model_card.h"
#include "trainer/network/resnet.h"

namespace cps {

/// Runs the network on the images, in batches of card.options.batch_size, with inputs normalised as the card
/// says. Returns the outputs of its last layer, [images, unit_count(head)] float on the CPU, in the images'
/// order. Sizes may be mixed. Leaves the network in evaluation mode.
torch::Tensor run_last_layer(Network& network, std::span<const BatchImage> images, const ModelCard& card);

/// The same of a brown_conrady head (not checked), whose outputs are standardised.
std::vector<Outputs> run_network(Network& network, std::span<const BatchImage> images, const ModelCard& card);

}  // namespace cps
