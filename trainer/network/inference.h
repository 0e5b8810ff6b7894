#pragma once

#include <span>
#include <vector>

#include "trainer/calibration/targets.h"
#include "trainer/network/resnet.h"
#include "trainer/network/tensor_batch.h"

namespace cps {

/// Runs the network on the images. Returns its standardised outputs for each, in the images' order. Sizes may
/// be mixed. Leaves the network in evaluation mode.
std::vector<Outputs> run_network(Network& network, std::span<const BatchImage> images,
                                 const PixelStatistics& statistics, int batch_size);

}  // namespace cps
