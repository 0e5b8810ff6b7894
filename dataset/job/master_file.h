#pragma once

#include <filesystem>
#include <string>

#include "distortion/warp/render_noise.h"

namespace cps {

/// A master of three float channels as the bytes of an EXR file of half floats (at most ±65504), not
/// compressed with losses: channels R G B, and noise.R noise.G noise.B. The same pixels give the same bytes.
/// Throws std::runtime_error when it cannot be encoded.
std::string encode_master(const NoisyMaster& master);

/// What such a file holds, as floats. Throws std::runtime_error with one line, file first.
NoisyMaster read_master(const std::filesystem::path& file);

}  // namespace cps
