#pragma once

#include <vector>

#include "random/counter_hash.h"

/// The file with a few bytes overwritten, flipped, removed or repeated, digits changed, or with its end cut
/// off: a pure function of the stream.
std::vector<unsigned char> mutate_bytes(const std::vector<unsigned char>& original, cps::Stream stream);
