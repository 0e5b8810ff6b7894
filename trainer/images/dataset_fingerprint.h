#pragma once

#include <string>

#include "dataset/labels/reader.h"

namespace cps {

/// 16 hex digits over the image lists and every label number: the same for the same dataset wherever it lies.
std::string dataset_fingerprint(const Dataset& dataset);

}  // namespace cps
