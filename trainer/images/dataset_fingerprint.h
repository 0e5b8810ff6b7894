#pragma once

#include <string>

#include "dataset/labels/reader.h"

namespace cps {

/// SHA-256, in lower-case hex, of every label number and of the image lists. Does not depend on where the
/// dataset lies.
std::string dataset_fingerprint(const Dataset& dataset);

}  // namespace cps
