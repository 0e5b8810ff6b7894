#pragma once

#include <string>
#include <utility>
#include <vector>

#include "trainer/model/model_card.h"

namespace cps {

/// What a program must know to use the network without this one, by name: how to make the inputs, what the
/// outputs are, what is left to do with them, and which model it is (`weights_sha256`: the hash of
/// weights.pt). Names no folder of this machine.
std::vector<std::pair<std::string, std::string>> onnx_metadata(const ModelCard& card,
                                                               const std::string& weights_sha256);

}  // namespace cps
