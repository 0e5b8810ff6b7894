#pragma once

#include <span>
#include <vector>

#include "trainer/calibration/targets.h"
#include "trainer/network/resnet.h"
#include "trainer/network/tensor_batch.h"

namespace cps {

/// What `network` says about each image, standardised, in the images' order. Sizes may be mixed. Leaves the
/// network in evaluation mode.
std::vector<Outputs> run_network(Network& network, std::span<const BatchImage> images,
                                 const PixelStatistics& statistics, int batch_size);

}  // namespace cps
