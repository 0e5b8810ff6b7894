#pragma once

#include <span>
#include <vector>

#include "trainer/calibration/targets.h"
#include "trainer/fit/lens_fit.h"
#include "trainer/images/batches.h"
#include "trainer/model/model_card.h"
#include "trainer/network/resnet.h"

namespace cps {

/// Runs the network on the images, in batches of card.options.batch_size, with inputs normalised as the card
/// says. Returns what its head makes of them (head_rows()), [images, row_width(head)] float on the CPU, in
/// the images' order. Sizes may be mixed. Leaves the network in evaluation mode.
torch::Tensor run_head(Network& network, std::span<const BatchImage> images, const ModelCard& card);

/// What a fit gets of each image: see frame_evidence(). The head must be one with a fit (not checked).
std::vector<FrameEvidence> run_evidence(Network& network, std::span<const BatchImage> images,
                                        const ModelCard& card);

/// The standardised outputs of a Brown–Conrady head (not checked).
std::vector<Outputs> run_network(Network& network, std::span<const BatchImage> images, const ModelCard& card);

}  // namespace cps
