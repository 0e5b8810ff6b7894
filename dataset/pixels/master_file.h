#pragma once

#include <filesystem>
#include <string>

#include "distortion/warp/render_noise.h"

namespace cps {

/// The bytes of an EXR file that holds a master of three float channels as half floats clamped to ±65504,
/// losslessly compressed: channels R G B, and noise.R noise.G noise.B. The same pixels give the same bytes.
/// Throws std::runtime_error when encoding fails.
std::string encode_master(const NoisyMaster& master);

/// The master in such a file, as floats. Throws std::runtime_error with one line, file first.
NoisyMaster read_master(const std::filesystem::path& file);

}  // namespace cps
